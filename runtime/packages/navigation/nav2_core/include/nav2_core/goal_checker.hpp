// The base of plugins that say whether a goal is reached.
#pragma once

#include <memory>
#include <string>

#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/twist.hpp"
#include "nav2_costmap_2d/costmap_2d_ros.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_core {

class GoalChecker {
 public:
  typedef std::shared_ptr<nav2_core::GoalChecker> Ptr;
  virtual ~GoalChecker() {}

  virtual void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                          const std::string& plugin_name,
                          const std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) = 0;
  virtual void reset() = 0;
  virtual bool isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                             const geometry_msgs::msg::Pose& goal_pose,
                             const geometry_msgs::msg::Twist& velocity) = 0;
  /// Parts that do not count have the lowest double. False when it has no tolerances.
  virtual bool getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                             geometry_msgs::msg::Twist& vel_tolerance) = 0;
};

}  // namespace nav2_core
