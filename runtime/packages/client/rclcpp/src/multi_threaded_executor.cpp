// The multi-threaded executor: each thread takes the next piece of work that may run.
#include "rclcpp/executors/multi_threaded_executor.hpp"

#include <algorithm>
#include <stdexcept>
#include <thread>
#include <vector>

namespace rclcpp {
namespace executors {

MultiThreadedExecutor::MultiThreadedExecutor(const rclcpp::ExecutorOptions& options,
                                             size_t number_of_threads, bool yield_before_execute,
                                             std::chrono::nanoseconds timeout)
    : rclcpp::Executor(options),
      number_of_threads_(number_of_threads > 0
                             ? number_of_threads
                             : std::max<size_t>(std::thread::hardware_concurrency(), 2)),
      yield_before_execute_(yield_before_execute),
      next_exec_timeout_(timeout) {}

void MultiThreadedExecutor::spin() {
  if (spinning.exchange(true)) {
    throw std::runtime_error("spin() called while already spinning");
  }
  struct Reset {
    std::atomic_bool& flag;
    ~Reset() { flag = false; }
  } reset{spinning};
  std::vector<std::thread> threads;
  for (size_t i = 0; i + 1 < number_of_threads_; ++i) {
    threads.emplace_back([this, i] { run(i); });
  }
  run(number_of_threads_ - 1);
  for (std::thread& thread : threads) {
    thread.join();
  }
}

void MultiThreadedExecutor::run(size_t) {
  while (rclcpp::ok(context_) && spinning) {
    rclcpp::AnyExecutable any_executable;
    if (!get_next_executable(any_executable, next_exec_timeout_)) {
      continue;
    }
    if (yield_before_execute_) {
      std::this_thread::yield();
    }
    execute_any_executable(any_executable);
  }
}

}  // namespace executors
}  // namespace rclcpp
