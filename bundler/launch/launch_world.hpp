// Lets launch files see what is installed, and the workspace around them, under the paths that the
// site has. An edge: reads files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/launch_scope.hpp"
#include "bundler/workspace/discovery.hpp"

namespace ros2wasm {

/// The manifest's folder, for launch files that are named by their place in it.
inline constexpr const char* kLaunchWorkspace = "/workspace";

/// Files of `folder` below kLaunchWorkspace, those of packages below /opt/ros/<distro>/share. No
/// path and no link leads out of these. The values must outlive the world.
[[nodiscard]] LaunchWorld installed_launch_world(const std::filesystem::path& folder,
                                                 const std::vector<InstalledPackage>& installed,
                                                 const std::string& distro);

/// The same before anything is built: share/<package>/ is the folder of the package's sources,
/// where launch files and parameters mostly have the places that they are installed to. Packages
/// that are no part of the workspace exist, without files.
[[nodiscard]] LaunchWorld source_launch_world(const std::filesystem::path& folder,
                                              const std::vector<LocalPackage>& packages,
                                              const std::string& distro);

}  // namespace ros2wasm
