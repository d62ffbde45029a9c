// The goal is reached near its place and, when it was, near its orientation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_core/goal_checker.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_controller {

class SimpleGoalChecker : public nav2_core::GoalChecker {
 public:
  SimpleGoalChecker();

  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name,
                  const std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  void reset() override;
  bool isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                     const geometry_msgs::msg::Pose& goal_pose,
                     const geometry_msgs::msg::Twist& velocity) override;
  bool getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                     geometry_msgs::msg::Twist& vel_tolerance) override;

 protected:
  virtual rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  double xy_goal_tolerance_;   // m
  double yaw_goal_tolerance_;  // rad
  /// Once the place was reached, only the orientation counts: the robot may slide while it turns.
  bool stateful_;
  /// The robot may as well stand the other way round.
  bool symmetric_yaw_tolerance_;
  bool check_xy_;
  double xy_goal_tolerance_sq_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
  std::string plugin_name_;
};

}  // namespace nav2_controller
