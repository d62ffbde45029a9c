// `sources:` of the manifest.
#pragma once

#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// Reads the list into `manifest.sources`.
void read_sources(Binder& binder, const YamlNode& node, Manifest& manifest);

}  // namespace ros2wasm
