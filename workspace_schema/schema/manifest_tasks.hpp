// The entries of `tasks:` in a manifest: what a student does, and the checks that see it.
#pragma once

#include <vector>

#include "workspace_schema/schema/manifest.hpp"
#include "workspace_schema/schema/manifest_binding.hpp"

namespace ros2wasm {

/// The tasks without mistakes; those of the others are reported. R2W0106 a task has no check,
/// R2W0126 two tasks have one title, and what read_check() says.
[[nodiscard]] std::vector<TaskEntry> read_tasks(Binder& binder, const YamlNode& node);

}  // namespace ros2wasm
