// The mean velocity of the last while, from odometry.
#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "geometry_msgs/msg/twist.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_util {

class OdomSmoother {
 public:
  /// `filter_duration` in seconds.
  explicit OdomSmoother(const rclcpp::Node::WeakPtr& parent, double filter_duration = 0.3,
                        const std::string& odom_topic = "odom");
  explicit OdomSmoother(const nav2_util::LifecycleNode::WeakPtr& parent,
                        double filter_duration = 0.3, const std::string& odom_topic = "odom");

  inline geometry_msgs::msg::Twist getTwist() { return vel_smooth_.twist; }
  inline geometry_msgs::msg::TwistStamped getTwistStamped() { return vel_smooth_; }

 protected:
  void odomCallback(nav_msgs::msg::Odometry::SharedPtr msg);
  void updateState();

  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr odom_sub_;
  nav_msgs::msg::Odometry odom_cumulate_;
  geometry_msgs::msg::TwistStamped vel_smooth_;
  std::mutex odom_mutex_;
  rclcpp::Duration odom_history_duration_;
  std::deque<nav_msgs::msg::Odometry> odom_history_;
};

}  // namespace nav2_util
