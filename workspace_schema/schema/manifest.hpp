// The manifest, workspace.yaml version 1, as plain values after all checks that need no disk.
// Reading is in manifest_reader.cpp; nothing here touches the world.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/conda/channel_priority.hpp"
#include "workspace_schema/schema/named_source.hpp"

namespace ros2wasm {

/// A value with its place in the manifest.
template <typename T>
struct Spanned {
  T value{};
  SourceSpan span;
};

/// A ROS parameter value; integers and doubles are kept apart as ROS 2 does.
using ParameterValue =
    std::variant<bool, std::int64_t, double, std::string, std::vector<bool>,
                 std::vector<std::int64_t>, std::vector<double>, std::vector<std::string>>;

struct Author {
  std::string name;
  std::string email;        ///< may be empty
  std::string orcid;        ///< may be empty
  std::string affiliation;  ///< may be empty
};

/// How the site is cited, beside its title, version, authors and license.
struct Citation {
  std::string date_released;  ///< `2026-11-23`
  std::string doi;            ///< `10.5281/zenodo.1234`; may be empty
  std::string repository;     ///< https address of the sources; may be empty
  std::string abstract;       ///< may be empty
  std::vector<std::string> keywords;
};

/// Other places of a channel, asked before it.
struct MirrorEntry {
  Spanned<std::string> channel;
  std::vector<Spanned<std::string>> urls;
};

enum class NodeOutput { kScreen, kLog, kBoth };

struct ParameterEntry {
  std::string name;  ///< dotted for nested keys
  ParameterValue value;
  /// How many of the node's parameter_files stand before it: whatever comes later wins.
  std::size_t files_before = 0;
};

/// One entry of `launch: [...]`.
struct NodeEntry {
  SourceSpan span;  ///< of the whole entry's first key
  Spanned<std::string> package;
  Spanned<std::string> executable;
  std::vector<Spanned<std::string>> linked_with = {};  ///< of a container: packages that it has
                                                       ///< components of too
  std::optional<Spanned<std::string>> name;            ///< ROS node name, if remapped
  std::optional<Spanned<std::string>> name_space;      ///< ROS namespace, absolute, if remapped
  std::vector<std::pair<std::string, std::string>> remappings;  ///< from, to; in order
  std::vector<ParameterEntry> parameters;
  std::vector<Spanned<std::string>> parameter_files;  ///< relative to the manifest
  std::vector<std::string> arguments;                 ///< passed before --ros-args
  std::vector<std::string> ros_arguments;             ///< right behind it; of launch files
  bool is_command = false;  ///< of launch files: `ros2` with these arguments, of no package
  NodeOutput output = NodeOutput::kScreen;
  bool respawn = false;
};

/// One entry of `programs:`: what a site carries although nothing starts it.
struct ProgramEntry {
  SourceSpan span;
  Spanned<std::string> package;
  std::optional<Spanned<std::string>> executable;  ///< else all of the package
};

/// A condition on a value. `equals` is a boolean, a number or a text.
struct Comparison {
  std::optional<double> above;
  std::optional<double> below;
  std::optional<ParameterValue> equals;
  std::string matches;  ///< a regular expression; empty: any text

  [[nodiscard]] bool given() const { return above || below || equals || !matches.empty(); }
};

/// Messages come so often; without bounds: at least one comes.
struct RateCheck {
  std::string topic;  ///< absolute
  std::optional<double> above_hz;
  std::optional<double> below_hz;
};

/// A message has such a value.
struct MessageCheck {
  std::string topic;  ///< absolute
  std::string field;  ///< `pose.position.x`, `ranges[3]`
  Comparison value;
};

/// A node, or any, prints such a line.
struct LogCheck {
  std::optional<Spanned<std::string>> node;
  std::string pattern;
};

/// A node has a parameter of such a value.
struct ParameterCheck {
  std::string node;  ///< absolute name of the ROS node
  std::string name;
  Comparison value;
};

enum class CheckedState { kRunning, kExited, kCrashed };

/// A node's process gets there.
struct StateCheck {
  Spanned<std::string> node;
  CheckedState state = CheckedState::kRunning;
};

struct ExitCheck {
  Spanned<std::string> node;
  std::int64_t code = 0;
};

/// One entry of `checks:`: what must be seen while the site runs.
struct CheckEntry {
  SourceSpan span;
  std::string title;  ///< may be empty
  std::variant<RateCheck, MessageCheck, LogCheck, ParameterCheck, StateCheck, ExitCheck> what;
  std::int64_t within_ms = 10'000;  ///< of the site's time
};

/// One entry of `tasks:`: what a student is asked to do. Texts are Markdown and may be empty.
struct TaskEntry {
  SourceSpan span;
  Spanned<std::string> title;  ///< each once
  std::string text;
  std::vector<CheckEntry> checks;  ///< one or more; `within_ms` of them means nothing
  std::string hint;
  std::string solution;
};

/// A launch argument with its value, as `name:=value` says it.
struct GivenArgument {
  Spanned<std::string> name;
  std::string value;
};

/// One entry of `python: wheels:`: a wheel of Python files, or one compiled for the Python of
/// sites.
struct WheelEntry {
  Spanned<std::string> place;  ///< relative to the manifest, or an address
  bool is_url = false;
  std::string sha256;  ///< hex; of a file it may be empty
};

/// `python: index: none`: no library of Pyodide's distribution is taken.
inline constexpr std::string_view kNoPythonIndex = "none";

/// `site: budget:`, in bytes: what the site may weigh.
struct SiteBudget {
  std::optional<Spanned<std::uint64_t>> total;
  std::optional<Spanned<std::uint64_t>> compressed;  ///< by gzip, each file for itself
};

struct Manifest {
  std::string file;  ///< path as given, for messages
  int schema = 1;
  Spanned<std::string> name;
  std::string title;
  std::string version;
  std::vector<Author> authors;
  std::string license;
  std::optional<Citation> citation;
  std::string distro = "jazzy";
  std::vector<Spanned<std::string>> channels;  ///< empty: the embedded channel
  ChannelPriority channel_priority = ChannelPriority::kStrict;
  std::optional<Spanned<std::string>> channel_alias;  ///< address that bare channel names are below
  std::vector<MirrorEntry> mirrors;
  std::vector<Spanned<std::string>> ignore_link_scripts;  ///< packages that need not run theirs
  std::vector<Spanned<std::string>> dependencies;  ///< conda match specs or ROS package names
  std::vector<Spanned<std::string>> packages;      ///< paths or globs, relative to the manifest
  std::vector<NamedSource> sources;                ///< packages that lie elsewhere
  std::vector<WheelEntry> wheels;                  ///< for Python nodes, each project once
  /// Libraries of Pyodide's distribution, each with or without versions: "scipy", "pandas >=2".
  std::vector<Spanned<std::string>> python_packages;
  /// Where their files come from: an address, a path relative to the manifest, or kNoPythonIndex.
  std::optional<Spanned<std::string>> python_index;
  /// Another list of libraries than that of Pyodide's distribution: a pyodide-lock.json, relative
  /// to the manifest.
  std::optional<Spanned<std::string>> python_lock;
  bool fetches_fuel = false;  ///< `simulation: fuel:`: models of Gazebo Fuel come when it is packed
  std::optional<Spanned<std::string>> launch_file;
  std::vector<GivenArgument> launch_arguments;  ///< for the launch file, in the written order
  /// Variables that the launch file and its nodes find, beside those of every site.
  std::map<std::string, std::string> launch_variables;
  std::vector<NodeEntry> nodes;
  std::vector<ProgramEntry> programs;
  std::vector<CheckEntry> checks;
  std::vector<TaskEntry> tasks;
  std::map<std::string, std::string> ui;  ///< scalar options of `ui:` (theme, autostart)
  std::string ui_layout;  ///< `ui: layout:` as one line of JSON; empty: the page's own
  std::optional<Spanned<std::string>> ui_text;      ///< Markdown file of the text panel
  std::vector<Spanned<std::string>> ui_bags;        ///< recordings that the page plays
  std::optional<Spanned<std::string>> ui_notebook;  ///< Jupyter notebook of the notebook panel
  std::map<std::string, std::string> site;          ///< scalar options of `site:`
  std::vector<Spanned<std::string>> site_embed;     ///< origins of pages that may act on it
  SiteBudget site_budget;
  std::vector<Diagnostic> warnings;  ///< found while reading; show them, then go on
};

}  // namespace ros2wasm
