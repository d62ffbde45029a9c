// `launch` of the manifest: a launch file, one with arguments, or a list of nodes.
#pragma once

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// Fills `launch_file` with `launch_arguments`, or `nodes`.
void read_launch(Binder& binder, const YamlNode& node, Manifest& manifest);

/// The value of `programs:`.
[[nodiscard]] std::vector<ProgramEntry> read_programs(Binder& binder, const YamlNode& node);

}  // namespace ros2wasm
