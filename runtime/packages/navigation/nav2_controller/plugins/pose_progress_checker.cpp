// See pose_progress_checker.hpp.
#include "nav2_controller/plugins/pose_progress_checker.hpp"

#include <cmath>

#include "angles/angles.h"
#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_controller {

void PoseProgressChecker::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                     const std::string& plugin_name) {
  SimpleProgressChecker::initialize(parent, plugin_name);
  const auto node = parent.lock();
  nav2_util::declare_parameter_if_not_declared(node, plugin_name + ".required_movement_angle",
                                               rclcpp::ParameterValue(0.5));
  node->get_parameter_or(plugin_name + ".required_movement_angle", required_movement_angle_, 0.5);
}

bool PoseProgressChecker::hasMoved(const geometry_msgs::msg::Pose2D& pose) const {
  const double turn = angles::shortest_angular_distance(baseline_pose_.theta, pose.theta);
  return SimpleProgressChecker::hasMoved(pose) || std::abs(turn) > required_movement_angle_;
}

rcl_interfaces::msg::SetParametersResult PoseProgressChecker::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_name() == plugin_name_ + ".required_movement_angle" &&
        parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      required_movement_angle_ = parameter.as_double();
    }
  }
  return SimpleProgressChecker::dynamicParametersCallback(parameters);
}

}  // namespace nav2_controller

PLUGINLIB_EXPORT_CLASS(nav2_controller::PoseProgressChecker, nav2_core::ProgressChecker)
