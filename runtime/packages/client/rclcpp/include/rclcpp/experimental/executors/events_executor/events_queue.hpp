// The queue between what finds events and what executes them; users may write their own.
#pragma once

#include <chrono>
#include <cstddef>

#include "rclcpp/experimental/executors/events_executor/events_executor_event_types.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {
namespace experimental {
namespace executors {

class EventsQueue {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(EventsQueue)

  EventsQueue() = default;
  virtual ~EventsQueue() = default;

  virtual void enqueue(const ExecutorEvent& event) = 0;
  /// False when there is none until the timeout.
  virtual bool dequeue(ExecutorEvent& event,
                       std::chrono::nanoseconds timeout = std::chrono::nanoseconds::max()) = 0;
  virtual bool empty() const = 0;
  virtual size_t size() const = 0;
};

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
