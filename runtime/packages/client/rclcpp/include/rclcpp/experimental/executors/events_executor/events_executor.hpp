// The executor whose work goes through a queue of events, of the user's own kind if wanted.
#pragma once

#include <memory>

#include "rclcpp/executor.hpp"
#include "rclcpp/experimental/executors/events_executor/events_executor_event_types.hpp"
#include "rclcpp/experimental/executors/events_executor/events_queue.hpp"
#include "rclcpp/experimental/executors/events_executor/simple_events_queue.hpp"
#include "rclcpp/node.hpp"

namespace rclcpp {
namespace experimental {
namespace executors {

/// Differs from rclcpp on ROS machines: what is ready is found as the other executors find it and
/// enters the queue one by one; timers run in the thread that spins, also where a thread of their
/// own is asked for.
class EventsExecutor : public rclcpp::Executor {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(EventsExecutor)

  /// Throws std::invalid_argument without a queue.
  explicit EventsExecutor(
      EventsQueue::UniquePtr events_queue = std::make_unique<SimpleEventsQueue>(),
      bool execute_timers_separate_thread = false,
      const rclcpp::ExecutorOptions& options = rclcpp::ExecutorOptions());
  ~EventsExecutor() override = default;

  void spin() override;

 protected:
  bool run_executable(AnyExecutable& any_executable) override;

 private:
  RCLCPP_DISABLE_COPY(EventsExecutor)
  EventsQueue::UniquePtr events_queue_;
};

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
