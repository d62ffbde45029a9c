// The velocity of the last odometry.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "nav2_util/lifecycle_node.hpp"
#include "nav_2d_msgs/msg/twist2_d_stamped.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "nav_msgs/msg/odometry.hpp"

namespace nav_2d_utils {

class OdomSubscriber {
 public:
  /// The parameter `odom_topic` of the node names another topic.
  explicit OdomSubscriber(nav2_util::LifecycleNode::SharedPtr nh,
                          std::string default_topic = "odom") {
    odom_sub_ = nh->create_subscription<nav_msgs::msg::Odometry>(
        searchAndGetParam(nh, "odom_topic", default_topic), rclcpp::SystemDefaultsQoS(),
        [this](const nav_msgs::msg::Odometry::SharedPtr message) { odomCallback(message); });
  }

  inline nav_2d_msgs::msg::Twist2D getTwist() { return getTwistStamped().velocity; }
  inline nav_2d_msgs::msg::Twist2DStamped getTwistStamped() {
    const std::lock_guard<std::mutex> lock(odom_mutex_);
    return odom_vel_;
  }

 protected:
  void odomCallback(const nav_msgs::msg::Odometry::SharedPtr msg) {
    const std::lock_guard<std::mutex> lock(odom_mutex_);
    odom_vel_.header = msg->header;
    odom_vel_.velocity.x = msg->twist.twist.linear.x;
    odom_vel_.velocity.y = msg->twist.twist.linear.y;
    odom_vel_.velocity.theta = msg->twist.twist.angular.z;
  }

  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odom_sub_;
  nav_2d_msgs::msg::Twist2DStamped odom_vel_;
  std::mutex odom_mutex_;
};

}  // namespace nav_2d_utils
