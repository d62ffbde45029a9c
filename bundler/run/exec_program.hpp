// Turns this process into another program: its signals, terminal and exit code are then its own.
#pragma once

#include <string>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// Returns only when it failed: R2W0910. `arguments[0]` is the program's path.
[[nodiscard]] Diagnostic exec_program(std::vector<std::string> arguments);

}  // namespace ros2wasm
