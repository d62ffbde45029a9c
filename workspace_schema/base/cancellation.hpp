// The wish to stop, seen from the steps: poll `requested()` between units of work, or wait on
// `wake_fd()` together with a child process. Ctrl-C is turned into this by cli/interrupt.cpp; tests
// use their own flag.
#pragma once

#include <atomic>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

class Cancellation {
 public:
  /// Never requested: for tests and for steps that are too short to stop.
  Cancellation() = default;

  /// `flag` must outlive every copy. `wake_fd` becomes readable when the flag is set, and stays so.
  explicit Cancellation(const std::atomic<bool>& flag, int wake_fd = -1)
      : flag_(&flag), wake_fd_(wake_fd) {}

  [[nodiscard]] bool requested() const {
    return flag_ != nullptr && flag_->load(std::memory_order_relaxed);
  }

  /// For poll(2) beside a child's pipe; -1 when there is none. Never read from it.
  [[nodiscard]] int wake_fd() const { return wake_fd_; }

 private:
  const std::atomic<bool>* flag_ = nullptr;
  int wake_fd_ = -1;
};

/// The diagnostic of a step that was cancelled. The exit code of the program is 130.
[[nodiscard]] inline Diagnostic interrupted() {
  return Diagnostic{.code = "R2W0903",
                    .kind = FailureKind::kInterrupted,
                    .message = "interrupted; nothing was changed"};
}

}  // namespace ros2wasm
