// Messages that stay in the process: who publishes, who listens, and who gets the object itself.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "rclcpp/detail/message_type.hpp"

namespace rclcpp {

class SubscriptionBase;

namespace detail {

/// A message that one listener owns, or that several share.
struct LocalMessage {
  std::shared_ptr<const void> shared;
  std::unique_ptr<void, void (*)(void*)> owned{nullptr, nullptr};
};

void add_local_subscription(const std::shared_ptr<SubscriptionBase>& subscription);
size_t count_local_subscriptions(const std::string& topic, const char* type);
/// Takes `object`. Gives it, or copies of it, to all local subscriptions of the topic.
void deliver_locally(const std::string& topic, const char* type, void* object,
                     const ObjectFunctions& functions);

/// Publishers that deliver by pointer: what comes from them over the bus is not taken twice.
void add_local_publisher(const uint8_t gid[16]);
void remove_local_publisher(const uint8_t gid[16]);
bool is_local_publisher(const uint8_t gid[16]);

}  // namespace detail
}  // namespace rclcpp
