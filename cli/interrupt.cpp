// See interrupt.hpp. The only global state of the program: a signal handler can reach nothing else.
#include "cli/interrupt.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>

namespace ros2wasm {
namespace {

std::atomic<bool> interrupt_requested{false};
std::atomic<int> first_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
              "the handler may use nothing else");
int wake_pipe_write_end = -1;

extern "C" void on_interrupt(int signal) {
  int none = 0;
  first_signal.compare_exchange_strong(none, signal, std::memory_order_relaxed);
  interrupt_requested.store(true, std::memory_order_relaxed);
  if (wake_pipe_write_end >= 0) {
    const char byte = 1;
    [[maybe_unused]] const auto written = write(wake_pipe_write_end, &byte, 1);
  }
}

/// The call that failed says so: a closed pipe, a file beyond the limit of its size.
extern "C" void on_failed_write(int) {}

}  // namespace

Cancellation install_interrupt_handlers() {
  std::array<int, 2> ends{-1, -1};
  if (pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) == 0) wake_pipe_write_end = ends[1];

  struct sigaction stop {};
  stop.sa_handler = on_interrupt;
  sigemptyset(&stop.sa_mask);
  // No SA_RESTART: a blocked call returns and the step looks at the flag. The second signal ends
  // the program.
  stop.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &stop, nullptr);

  struct sigaction failed_write {};
  failed_write.sa_handler =
      on_failed_write;  // a handler, not SIG_IGN, which children would inherit
  sigemptyset(&failed_write.sa_mask);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaction(signal, &failed_write, nullptr);
  return Cancellation(interrupt_requested, ends[0]);
}

bool asked_to_end() {
  return first_signal.load(std::memory_order_relaxed) == SIGTERM;
}

}  // namespace ros2wasm
