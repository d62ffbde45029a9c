// Lets launch files see what is installed, and the workspace around them, under the paths that the
// site has. An edge: reads files.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bundler/launch/launch_graph.hpp"
#include "bundler/launch/launch_paths.hpp"
#include "bundler/launch/launch_scope.hpp"
#include "bundler/workspace/discovery.hpp"

namespace ros2wasm {

/// A folder of this machine, and where launch files see it.
struct LaunchFolder {
  std::string at;
  std::filesystem::path from;
  bool holds_modules = false;  ///< that launch files in Python can import
};

/// `folder` as kLaunchWorkspace, and what packages install below /opt/ros/<distro>/share. Modules
/// of the packages that are not in `environment`.
[[nodiscard]] std::vector<LaunchFolder> installed_launch_folders(
    const std::filesystem::path& folder, const std::vector<InstalledPackage>& installed,
    const std::filesystem::path& environment, const std::string& distro);

/// The same before anything is built: share/<package>/ is the folder of the package's sources,
/// where launch files and parameters mostly have the places that they are installed to.
[[nodiscard]] std::vector<LaunchFolder> source_launch_folders(
    const std::filesystem::path& folder, const std::vector<LocalPackage>& packages,
    const std::string& distro);

/// Files of `folders`; no path and no link leads out of these. `is_built`: else packages without a
/// folder exist too, and what cannot be read in a package may be there later.
[[nodiscard]] LaunchWorld launch_world(std::vector<LaunchFolder> folders, const std::string& distro,
                                       bool is_built);

/// Where a path of the site is on this machine.
[[nodiscard]] std::optional<std::filesystem::path> real_path(
    const std::vector<LaunchFolder>& folders, const std::string& path);

}  // namespace ros2wasm
