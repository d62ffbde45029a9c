// As SimpleGoalChecker, and the robot stands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "nav2_controller/plugins/simple_goal_checker.hpp"

namespace nav2_controller {

class StoppedGoalChecker : public SimpleGoalChecker {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name,
                  const std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) override;
  bool isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                     const geometry_msgs::msg::Pose& goal_pose,
                     const geometry_msgs::msg::Twist& velocity) override;
  bool getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                     geometry_msgs::msg::Twist& vel_tolerance) override;

 protected:
  rcl_interfaces::msg::SetParametersResult dynamicParametersCallback(
      std::vector<rclcpp::Parameter> parameters) override;

  double rot_stopped_velocity_ = 0.25;    // rad/s
  double trans_stopped_velocity_ = 0.25;  // m/s
};

}  // namespace nav2_controller
