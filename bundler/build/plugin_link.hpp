// Links the programs that load plugins (pluginlib) once more when all packages are built: with the
// libraries whose descriptions name a base class of the program's package, or of one that it needs.
#pragma once

#include <filesystem>
#include <map>
#include <vector>

#include "bundler/build/build_workspace.hpp"

namespace ros2wasm {

/// The program with its plugins, by the one without. Each is kept in the cache under the hash of
/// what it is linked from. R2W0504 and R2W0505 as for any program.
[[nodiscard]] Outcome<std::map<std::filesystem::path, std::filesystem::path>> link_plugins(
    const std::vector<LocalPackage>& packages, const std::vector<BuiltPackage>& built,
    const BuildTools& tools, const BuildSettings& settings, const Cancellation& cancellation,
    const ProgressSink& progress);

}  // namespace ros2wasm
