// Runs callbacks in several threads.
#pragma once

#include <chrono>
#include <cstddef>

#include "rclcpp/executor.hpp"

namespace rclcpp {
namespace executors {

class MultiThreadedExecutor : public rclcpp::Executor {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(MultiThreadedExecutor)

  /// `number_of_threads` 0: as many as the machine runs at once, at least 2.
  explicit MultiThreadedExecutor(const rclcpp::ExecutorOptions& options = rclcpp::ExecutorOptions(),
                                 size_t number_of_threads = 0, bool yield_before_execute = false,
                                 std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1));
  ~MultiThreadedExecutor() override = default;

  void spin() override;
  size_t get_number_of_threads() { return number_of_threads_; }

 protected:
  void run(size_t this_thread_number);

 private:
  RCLCPP_DISABLE_COPY(MultiThreadedExecutor)
  size_t number_of_threads_;
  bool yield_before_execute_;
  std::chrono::nanoseconds next_exec_timeout_;
};

}  // namespace executors
}  // namespace rclcpp
