// Brings the parameter files that nodes name. An edge: reads files.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/launch/launch_graph.hpp"

namespace ros2wasm {

/// Reads the parameter files of all nodes from beside the manifest into `files`; R2W0403 for each
/// that cannot be read.
[[nodiscard]] Diagnostics read_parameter_files(const std::vector<NodeEntry>& entries,
                                               const std::filesystem::path& folder,
                                               ParameterFiles& files);

}  // namespace ros2wasm
