// Velocities with or without a header, as the parameter `enable_stamped_cmd_vel` says.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_util {

class TwistSubscriber {
 public:
  template <typename TwistCallbackT, typename TwistStampedCallbackT>
  explicit TwistSubscriber(nav2_util::LifecycleNode::SharedPtr node, const std::string& topic,
                           const rclcpp::QoS& qos, TwistCallbackT&& TwistCallback,
                           TwistStampedCallbackT&& TwistStampedCallback) {
    read_parameter(node);
    if (is_stamped_) {
      twist_stamped_sub_ = node->create_subscription<geometry_msgs::msg::TwistStamped>(
          topic, qos, std::forward<TwistStampedCallbackT>(TwistStampedCallback));
    } else {
      twist_sub_ = node->create_subscription<geometry_msgs::msg::Twist>(
          topic, qos, std::forward<TwistCallbackT>(TwistCallback));
    }
  }

  /// Only with a header. Throws std::invalid_argument when the parameter says otherwise.
  template <typename TwistStampedCallbackT>
  explicit TwistSubscriber(nav2_util::LifecycleNode::SharedPtr node, const std::string& topic,
                           const rclcpp::QoS& qos, TwistStampedCallbackT&& TwistStampedCallback) {
    read_parameter(node);
    if (!is_stamped_) {
      throw std::invalid_argument(
          "enable_stamped_cmd_vel must be true when using this constructor!");
    }
    twist_stamped_sub_ = node->create_subscription<geometry_msgs::msg::TwistStamped>(
        topic, qos, std::forward<TwistStampedCallbackT>(TwistStampedCallback));
  }

 protected:
  void read_parameter(const nav2_util::LifecycleNode::SharedPtr& node) {
    declare_parameter_if_not_declared(node, "enable_stamped_cmd_vel",
                                      rclcpp::ParameterValue(false));
    node->get_parameter("enable_stamped_cmd_vel", is_stamped_);
  }

  bool is_stamped_{false};
  rclcpp::Subscription<geometry_msgs::msg::Twist>::SharedPtr twist_sub_{nullptr};
  rclcpp::Subscription<geometry_msgs::msg::TwistStamped>::SharedPtr twist_stamped_sub_{nullptr};
};

}  // namespace nav2_util
