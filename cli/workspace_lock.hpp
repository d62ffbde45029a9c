// The lock of a workspace, for commands that only look at it.
#pragma once

#include <string>

#include "workspace_schema/schema/lock.hpp"

namespace ros2wasm {

/// ros2wasm.lock of a workspace's folder, or of the folder of its manifest; empty: the current
/// folder. R2W0330 there is none, R2W0310 it cannot be read.
[[nodiscard]] Outcome<Lock> read_workspace_lock(const std::string& workspace);

}  // namespace ros2wasm
