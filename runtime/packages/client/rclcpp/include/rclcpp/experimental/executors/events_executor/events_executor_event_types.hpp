// What waits in the queue of an events executor.
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
  /// What runs it; a queue keeps it and hands it back.
  std::shared_ptr<void> data;
  int waitable_data;
  ExecutorEventType type;
  size_t num_events;
};

}  // namespace executors
}  // namespace experimental
}  // namespace rclcpp
