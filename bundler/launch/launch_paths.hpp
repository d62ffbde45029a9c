// Where launch files see what a site has, and what every program of it finds in its environment.
// Pure.
#pragma once

#include <map>
#include <string>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The manifest's folder, for launch files that are named by their place in it.
inline constexpr const char* kLaunchWorkspace = "/workspace";

/// "/opt/ros/jazzy"
[[nodiscard]] std::string launch_prefix(const std::string& distro);

/// "/opt/ros/jazzy/share/demo"
[[nodiscard]] std::string launch_share(const std::string& distro, const std::string& package);

/// For messages: a file of the workspace by its place there, one of a package as
/// share/<package>/...
[[nodiscard]] std::string shown_launch_path(const std::string& path, const std::string& prefix);

[[nodiscard]] std::map<std::string, std::string> launch_environment(const std::string& distro);

/// R2W0413.
[[nodiscard]] Diagnostic unreadable_launch_path(const std::string& path, std::string why);

/// The same for a path in no folder that a site has.
[[nodiscard]] Diagnostic no_launch_path(const std::string& path, const std::string& prefix);

inline constexpr const char* kNoSuchLaunchFile = "there is no such file";

}  // namespace ros2wasm
