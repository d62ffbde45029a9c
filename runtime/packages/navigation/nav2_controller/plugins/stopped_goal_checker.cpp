// See stopped_goal_checker.hpp.
#include "nav2_controller/plugins/stopped_goal_checker.hpp"

#include <cmath>

#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_controller {

using nav2_util::declare_parameter_if_not_declared;

void StoppedGoalChecker::initialize(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, const std::string& plugin_name,
    const std::shared_ptr<nav2_costmap_2d::Costmap2DROS> costmap_ros) {
  SimpleGoalChecker::initialize(parent, plugin_name, costmap_ros);
  const auto node = parent.lock();
  declare_parameter_if_not_declared(node, plugin_name + ".rot_stopped_velocity",
                                    rclcpp::ParameterValue(0.25));
  declare_parameter_if_not_declared(node, plugin_name + ".trans_stopped_velocity",
                                    rclcpp::ParameterValue(0.25));
  node->get_parameter(plugin_name + ".rot_stopped_velocity", rot_stopped_velocity_);
  node->get_parameter(plugin_name + ".trans_stopped_velocity", trans_stopped_velocity_);
}

bool StoppedGoalChecker::isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                                       const geometry_msgs::msg::Pose& goal_pose,
                                       const geometry_msgs::msg::Twist& velocity) {
  return SimpleGoalChecker::isGoalReached(query_pose, goal_pose, velocity) &&
         std::abs(velocity.angular.z) <= rot_stopped_velocity_ &&
         std::hypot(velocity.linear.x, velocity.linear.y) <= trans_stopped_velocity_;
}

bool StoppedGoalChecker::getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                                       geometry_msgs::msg::Twist& vel_tolerance) {
  SimpleGoalChecker::getTolerances(pose_tolerance, vel_tolerance);
  vel_tolerance.linear.x = trans_stopped_velocity_;
  vel_tolerance.linear.y = trans_stopped_velocity_;
  vel_tolerance.angular.z = rot_stopped_velocity_;
  return true;
}

rcl_interfaces::msg::SetParametersResult StoppedGoalChecker::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_type() != rclcpp::ParameterType::PARAMETER_DOUBLE) continue;
    const std::string& name = parameter.get_name();
    if (name == plugin_name_ + ".rot_stopped_velocity")
      rot_stopped_velocity_ = parameter.as_double();
    if (name == plugin_name_ + ".trans_stopped_velocity") {
      trans_stopped_velocity_ = parameter.as_double();
    }
  }
  return SimpleGoalChecker::dynamicParametersCallback(parameters);
}

}  // namespace nav2_controller

PLUGINLIB_EXPORT_CLASS(nav2_controller::StoppedGoalChecker, nav2_core::GoalChecker)
