// The `parameters` of a node in the manifest.
#pragma once

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// A mapping, or a list of mappings and parameter files. Nested mappings become dotted names;
/// values keep the type that YAML gives them; a list has values of one type. R2W0109, R2W0104,
/// R2W0105; warns with R2W0113.
void read_parameters(Binder& binder, const YamlNode& node, NodeEntry& entry);

}  // namespace ros2wasm
