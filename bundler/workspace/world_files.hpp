// Worlds and models of Gazebo in the packages of a workspace.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/workspace/discovery.hpp"
#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// R2W0531: mistakes in the files `*.sdf` and `*.world`, as the simulator of a site finds them.
/// They are warnings, as the launch file may start another one. A file whose included models are
/// not in the workspace is not judged. `base` and `shown_base` are those of shown_path().
[[nodiscard]] Diagnostics check_worlds(const std::vector<LocalPackage>& packages,
                                       const std::filesystem::path& base,
                                       const std::filesystem::path& shown_base);

}  // namespace ros2wasm
