// Rights that this process gives up for good, as do the programs that it executes or starts. For
// child programs that run untrusted code.
#pragma once

namespace ros2wasm {

/// No socket can be opened any more, of any family: the system refuses it with EACCES. What is open
/// stays. False, with errno, when the system cannot do that. Safe between fork and exec.
[[nodiscard]] bool give_up_sockets();

}  // namespace ros2wasm
