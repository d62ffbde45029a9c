// The context of substitutions: variables, the environment, the files of packages. Values, but for
// LaunchWorld, through which the caller lets files in.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bundler/launch/launch_text.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A request to the interpreter of launch files in Python, a line of JSON, and what is answered to
/// what it asks in between. The answer is a line of JSON too.
using LaunchPython = std::function<Outcome<std::string>(
    const std::string& request, const std::function<std::string(const std::string& asked)>& reply)>;

/// Paths are those of the site: `/opt/ros/<distro>/share/<package>/...` for what packages install.
struct LaunchWorld {
  std::function<Outcome<std::string>(const std::string& path)> read;
  /// The prefix that a package is installed in; nothing when there is no such package.
  std::function<std::optional<std::string>(const std::string& package)> prefix_of;
  std::map<std::string, std::string> environment;     ///< of every process of the site
  std::map<std::string, std::string> variables = {};  ///< what the manifest sets beside these
  /// The names in a folder, sorted; empty when the path is not a folder.
  std::function<std::vector<std::string>(const std::string& folder)> names_in = {};
  /// How messages name a file; empty: by its path.
  std::function<std::string(const std::string& path)> shown = {};
  /// Whether a file that cannot be read now may be there when the site is packed; empty: none.
  std::function<bool(const std::string& path)> is_later = {};
  /// Called for a file that is skipped because it may be there later; may be empty.
  std::function<void(const std::string& path, const SourceSpan& from)> note_later = {};
  /// The places where launch arguments were given, by name; none for arguments that are not in a
  /// file.
  std::map<std::string, SourceSpan> given_at = {};
  LaunchPython python = {};  ///< empty: launch files in Python cannot be read

  [[nodiscard]] std::string shown_path(const std::string& path) const {
    return shown ? shown(path) : path;
  }
};

/// How a manifest sets a variable of the environment, to paste.
[[nodiscard]] std::string variable_in_manifest(const std::string& name);

/// A parameter, or a file of them, that is set for all nodes that follow.
struct LaunchParameter {
  std::string name;
  ParameterValue value;
  std::optional<Spanned<std::string>> file;  ///< instead of name and value
};

/// The state that a group restores at its end.
struct LaunchScope {
  std::map<std::string, std::string> configurations;
  std::map<std::string, std::string> environment;  ///< what the file sets
  std::string ros_namespace;                       ///< pushed ones together; may be empty
  std::vector<LaunchParameter> parameters;
  std::vector<std::pair<std::string, std::string>> remappings;
  std::map<std::string, std::string> loop;   ///< of for_each and for
  std::map<std::string, std::string> event;  ///< of what a handler follows: `event.reason`
};

struct LaunchFilePlace {
  std::string path;
  [[nodiscard]] std::string directory() const { return path.substr(0, path.rfind('/')); }
  [[nodiscard]] std::string name() const { return path.substr(path.rfind('/') + 1); }
};

/// The text that the pieces come to. R2W0411 a substitution that cannot be, R2W0412 a variable that
/// is not set, R2W0413 a package or file that is not there, R2W0414 a command,
/// R2W0418 and R2W0120 a description that xacro cannot expand.
[[nodiscard]] Outcome<std::string> evaluate_text(const LaunchText& text, const SourceSpan& span,
                                                 const LaunchScope& scope,
                                                 const LaunchFilePlace& file,
                                                 const LaunchWorld& world);

/// true, false, 1 or 0 in any case; nothing otherwise.
[[nodiscard]] std::optional<bool> condition_of(std::string_view text);

}  // namespace ros2wasm
