// Links the programs that load plugins (pluginlib) once more when all packages are built: with the
// libraries whose descriptions name a base class of the program's package, or of one that it needs.
// Programs of the channels too, such as ros2_control_node, when the workspace has plugins for them.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bundler/build/build_workspace.hpp"
#include "bundler/build/link_kit.hpp"

namespace ros2wasm {

/// A library of plugins, with the package that has it.
struct PluginLibrary {
  LinkKit kit;
  const BuiltPackage* package = nullptr;
};

/// A program's arguments with those of the plugins. Their libraries come first, whole, so that each
/// class registers itself: what the program or another library links of them too is there already.
/// `built`: a library is one of a package and a name, as both kits may have copies of it.
[[nodiscard]] std::vector<std::string> arguments_with_plugins(
    const LinkKit& program, const std::vector<const PluginLibrary*>& plugins,
    const std::vector<BuiltPackage>& built);

/// The workspace's packages, and those of the channels that have kits.
[[nodiscard]] std::vector<BuiltPackage> with_channel_packages(
    const std::vector<BuiltPackage>& built, const BuildSettings& settings);

/// All libraries of plugins in the packages; these must outlive the result.
[[nodiscard]] Outcome<std::vector<PluginLibrary>> plugin_libraries(
    const std::vector<BuiltPackage>& built);

/// Those whose base class is of one of the packages named, or of one that these need. What packages
/// of the channels need, their package.xml in the environment says.
[[nodiscard]] std::vector<const PluginLibrary*> plugins_for(
    const std::vector<std::string>& names, const std::vector<LocalPackage>& packages,
    const BuildSettings& settings, const std::vector<PluginLibrary>& libraries);

/// The program with its plugins, by the one without. Each is kept in the cache under the hash of
/// what it is linked from. R2W0504 and R2W0505 as for any program.
[[nodiscard]] Outcome<std::map<std::filesystem::path, std::filesystem::path>> link_plugins(
    const std::vector<LocalPackage>& packages, const std::vector<BuiltPackage>& built,
    const BuildTools& tools, const BuildSettings& settings, const Cancellation& cancellation,
    const ProgressSink& progress);

}  // namespace ros2wasm
