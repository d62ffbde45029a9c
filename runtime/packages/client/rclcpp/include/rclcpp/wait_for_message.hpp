// Waits for one message.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "rclcpp/node.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/wait_set.hpp"

namespace rclcpp {

/// False after the timeout, or when the context was shut down. Negative: waits for ever.
template <class MsgT, class Rep = int64_t, class Period = std::milli>
bool wait_for_message(
    MsgT& out, std::shared_ptr<rclcpp::Subscription<MsgT>> subscription,
    std::shared_ptr<rclcpp::Context> context,
    std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1)) {
  rclcpp::WaitSet wait_set({}, {}, {}, {}, {}, {}, context);
  wait_set.add_subscription(subscription);
  const auto result = wait_set.wait(time_to_wait);
  if (result.kind() != rclcpp::WaitResultKind::Ready ||
      result.get_wait_set().get_rcl_wait_set().subscriptions[0] == nullptr) {
    return false;
  }
  rclcpp::MessageInfo info;
  return subscription->take(out, info);
}

template <class MsgT, class Rep = int64_t, class Period = std::milli>
bool wait_for_message(
    MsgT& out, rclcpp::Node::SharedPtr node, const std::string& topic,
    std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1),
    const rclcpp::QoS& qos = rclcpp::SystemDefaultsQoS()) {
  const auto subscription =
      node->create_subscription<MsgT>(topic, qos, [](const std::shared_ptr<const MsgT>&) {});
  return wait_for_message<MsgT>(out, subscription, node->get_node_base_interface()->get_context(),
                                time_to_wait);
}

}  // namespace rclcpp
