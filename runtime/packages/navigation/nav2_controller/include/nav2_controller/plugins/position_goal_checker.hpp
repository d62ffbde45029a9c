// The goal is reached near its place, in any orientation.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_core/goal_checker.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_controller {

class PositionGoalChecker : public nav2_core::GoalChecker {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name,
                  const std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  void reset() override;
  bool isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                     const geometry_msgs::msg::Pose& goal_pose,
                     const geometry_msgs::msg::Twist& velocity) override;
  bool getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                     geometry_msgs::msg::Twist& vel_tolerance) override;
  void setXYGoalTolerance(double tolerance);

 protected:
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters);

  double xy_goal_tolerance_ = 0.25;  // m
  double xy_goal_tolerance_sq_ = 0.0625;
  /// Once the place was reached, the goal is reached until reset().
  bool stateful_ = true;
  bool position_reached_ = false;
  std::string plugin_name_;
  rclcpp::node_interfaces::OnSetParametersCallbackHandle::SharedPtr dyn_params_handler_;
};

}  // namespace nav2_controller
