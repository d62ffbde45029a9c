// The key `python` of the manifest: wheels and libraries for Python nodes.
#pragma once

#include "workspace_schema/schema/manifest.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// R2W0102, R2W0103, R2W0106, R2W0114; R2W0119 a wheel that no site can run, or a project twice.
void read_python(Binder& binder, const YamlNode& node, Manifest& manifest);

}  // namespace ros2wasm
