// `launch` as a list of nodes.
#pragma once

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// One item of the list; nothing when it lacks a package or an executable.
[[nodiscard]] std::optional<NodeEntry> read_node(Binder& binder, const YamlNode& node);

/// One item of `programs`; nothing when it lacks a package.
[[nodiscard]] std::optional<ProgramEntry> read_program(Binder& binder, const YamlNode& node);

/// R2W0112: nodes that would have the same name. ROS 2 only warns, too.
void warn_of_equal_names(Binder& binder, const std::vector<NodeEntry>& nodes);

}  // namespace ros2wasm
