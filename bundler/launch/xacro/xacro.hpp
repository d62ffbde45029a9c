// Robot descriptions written with xacro: properties, macros, conditions and includes are replaced
// by what they come to, as the tool of that name does it. Pure but for what the world's functions
// read.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "bundler/launch/launch_scope.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct XacroRequest {
  std::string path;
  std::map<std::string, std::string> arguments;
  std::map<std::string, std::string> environment;
  std::string directory;  ///< of relative paths and `$(cwd)`
};

/// The file that `cat FILE` shows; nothing when the command is another.
[[nodiscard]] std::optional<std::string> cat_command(const std::string& line,
                                                     const std::string& directory);

/// The request of a command line that runs xacro; nothing when it runs another program. R2W0418
/// with `span` for arguments that xacro does not have.
[[nodiscard]] std::optional<Outcome<XacroRequest>> xacro_command(const std::string& line,
                                                                 const std::string& directory,
                                                                 const SourceSpan& span);

/// The expanded document. R2W0418, or R2W0120 for a file that is not an XML; both name the place in
/// the file that is at fault.
[[nodiscard]] Outcome<std::string> expand_xacro(const XacroRequest& request,
                                                const LaunchWorld& world);

}  // namespace ros2wasm
