// Velocities with or without a header, as the parameter `enable_stamped_cmd_vel` says.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"

namespace nav2_util {

class TwistPublisher {
 public:
  explicit TwistPublisher(nav2_util::LifecycleNode::SharedPtr node, const std::string& topic,
                          const rclcpp::QoS& qos)
      : topic_(topic) {
    declare_parameter_if_not_declared(node, "enable_stamped_cmd_vel",
                                      rclcpp::ParameterValue{false});
    node->get_parameter("enable_stamped_cmd_vel", is_stamped_);
    if (is_stamped_) {
      twist_stamped_pub_ = node->create_publisher<geometry_msgs::msg::TwistStamped>(topic_, qos);
    } else {
      twist_pub_ = node->create_publisher<geometry_msgs::msg::Twist>(topic_, qos);
    }
  }

  void on_activate() {
    is_stamped_ ? twist_stamped_pub_->on_activate() : twist_pub_->on_activate();
  }
  void on_deactivate() {
    is_stamped_ ? twist_stamped_pub_->on_deactivate() : twist_pub_->on_deactivate();
  }
  [[nodiscard]] bool is_activated() const {
    return is_stamped_ ? twist_stamped_pub_->is_activated() : twist_pub_->is_activated();
  }

  void publish(std::unique_ptr<geometry_msgs::msg::TwistStamped> velocity) {
    if (is_stamped_) {
      twist_stamped_pub_->publish(std::move(velocity));
    } else {
      twist_pub_->publish(std::make_unique<geometry_msgs::msg::Twist>(velocity->twist));
    }
  }

  [[nodiscard]] size_t get_subscription_count() const {
    return is_stamped_ ? twist_stamped_pub_->get_subscription_count()
                       : twist_pub_->get_subscription_count();
  }

 protected:
  std::string topic_;
  bool is_stamped_ = false;
  rclcpp_lifecycle::LifecyclePublisher<geometry_msgs::msg::Twist>::SharedPtr twist_pub_;
  rclcpp_lifecycle::LifecyclePublisher<geometry_msgs::msg::TwistStamped>::SharedPtr
      twist_stamped_pub_;
};

}  // namespace nav2_util
