// Ctrl-C, SIGTERM and SIGHUP become a flag that steps poll. The second one ends the program at
// once.
#pragma once

#include "workspace_schema/base/cancellation.hpp"

namespace ros2wasm {

/// Installs the handlers (once per program) and returns the flag's view. Also makes writes to a
/// closed pipe fail instead of killing the program, so that no step is cut in half; child processes
/// start with the default again.
[[nodiscard]] Cancellation install_interrupt_handlers();

/// Whether the first signal was SIGTERM, with which a program that only stops when told so ends
/// well; Ctrl-C is an interruption for it too.
[[nodiscard]] bool asked_to_end();

}  // namespace ros2wasm
