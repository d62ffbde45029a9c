// See simple_progress_checker.hpp.
#include "nav2_controller/plugins/simple_progress_checker.hpp"

#include <cmath>

#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "tf2/utils.h"

namespace nav2_controller {

using nav2_util::declare_parameter_if_not_declared;

void SimpleProgressChecker::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                       const std::string& plugin_name) {
  plugin_name_ = plugin_name;
  const auto node = parent.lock();
  clock_ = node->get_clock();
  declare_parameter_if_not_declared(node, plugin_name + ".required_movement_radius",
                                    rclcpp::ParameterValue(0.5));
  declare_parameter_if_not_declared(node, plugin_name + ".movement_time_allowance",
                                    rclcpp::ParameterValue(10.0));
  node->get_parameter_or(plugin_name + ".required_movement_radius", radius_, 0.5);
  double allowance = 10.0;
  node->get_parameter_or(plugin_name + ".movement_time_allowance", allowance, 10.0);
  time_allowance_ = rclcpp::Duration::from_seconds(allowance);
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

bool SimpleProgressChecker::check(geometry_msgs::msg::PoseStamped& current_pose) {
  geometry_msgs::msg::Pose2D pose;
  pose.x = current_pose.pose.position.x;
  pose.y = current_pose.pose.position.y;
  pose.theta = tf2::getYaw(current_pose.pose.orientation);
  if (!baseline_pose_set_ || hasMoved(pose)) {
    baseline_pose_ = pose;
    baseline_time_ = clock_->now();
    baseline_pose_set_ = true;
    return true;
  }
  return clock_->now() - baseline_time_ <= time_allowance_;
}

void SimpleProgressChecker::reset() {
  baseline_pose_set_ = false;
}

bool SimpleProgressChecker::hasMoved(const geometry_msgs::msg::Pose2D& pose) const {
  return std::hypot(pose.x - baseline_pose_.x, pose.y - baseline_pose_.y) > radius_;
}

rcl_interfaces::msg::SetParametersResult SimpleProgressChecker::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    if (parameter.get_type() != rclcpp::ParameterType::PARAMETER_DOUBLE) continue;
    const std::string& name = parameter.get_name();
    if (name == plugin_name_ + ".required_movement_radius") radius_ = parameter.as_double();
    if (name == plugin_name_ + ".movement_time_allowance") {
      time_allowance_ = rclcpp::Duration::from_seconds(parameter.as_double());
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

}  // namespace nav2_controller

PLUGINLIB_EXPORT_CLASS(nav2_controller::SimpleProgressChecker, nav2_core::ProgressChecker)
