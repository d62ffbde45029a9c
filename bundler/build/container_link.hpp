// Links the containers of several packages' components: one program for all of them, as natively
// one process loads their libraries.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/build/build_workspace.hpp"

namespace ros2wasm {

/// `container`: the name of the program that each of the packages has for its own components. The
/// result is linked from the kits of these, and kept in the cache as `program` of the first
/// package. R2W0504 and R2W0505 as for any program.
[[nodiscard]] Outcome<std::filesystem::path> link_container(
    const std::string& container, const std::string& program,
    const std::vector<std::string>& component_packages, const std::vector<LocalPackage>& packages,
    const std::vector<BuiltPackage>& built, const BuildTools& tools, const BuildSettings& settings,
    const Cancellation& cancellation, const ProgressSink& progress);

}  // namespace ros2wasm
