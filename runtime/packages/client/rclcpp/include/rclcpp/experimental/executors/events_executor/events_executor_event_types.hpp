// The events in the queue of an events executor.
#pragma once

#include <cstddef>
#include <memory>

namespace rclcpp {
namespace experimental {
namespace executors {

enum ExecutorEventType {
  CLIENT_EVENT,
  SUBSCRIPTION_EVENT,
  SERVICE_EVENT,
  TIMER_EVENT,
  WAITABLE_EVENT
};

struct ExecutorEvent {
  /// The entity's address.
  const void* entity_key;
  /// The object that runs the event; a queue stores it and returns it unchanged.
  std::shared_ptr<void> data;
  int waitable_data;
  ExecutorEventType type;
  size_t num_events;
};

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
