// What this process gives up for ever, as does all that it becomes or starts. For child programs
// that run code of strangers.
#pragma once

namespace ros2wasm {

/// No socket can be opened any more, of any family: the system refuses it with EACCES. What is open
/// stays. False, with errno, when the system cannot do that. Safe between fork and exec.
[[nodiscard]] bool give_up_sockets();

}  // namespace ros2wasm
