// See simple_goal_checker.hpp.
#include "nav2_controller/plugins/simple_goal_checker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "angles/angles.h"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"
#include "tf2/utils.h"

namespace nav2_controller {

using nav2_util::declare_parameter_if_not_declared;

SimpleGoalChecker::SimpleGoalChecker()
    : xy_goal_tolerance_(0.25),
      yaw_goal_tolerance_(0.25),
      stateful_(true),
      symmetric_yaw_tolerance_(false),
      check_xy_(true),
      xy_goal_tolerance_sq_(0.0625) {}

void SimpleGoalChecker::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                   const std::string& plugin_name,
                                   const std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) {
  plugin_name_ = plugin_name;
  const auto node = parent.lock();
  declare_parameter_if_not_declared(node, plugin_name + ".xy_goal_tolerance",
                                    rclcpp::ParameterValue(0.25));
  declare_parameter_if_not_declared(node, plugin_name + ".yaw_goal_tolerance",
                                    rclcpp::ParameterValue(0.25));
  declare_parameter_if_not_declared(node, plugin_name + ".stateful", rclcpp::ParameterValue(true));
  node->get_parameter(plugin_name + ".xy_goal_tolerance", xy_goal_tolerance_);
  node->get_parameter(plugin_name + ".yaw_goal_tolerance", yaw_goal_tolerance_);
  node->get_parameter(plugin_name + ".stateful", stateful_);
  declare_parameter_if_not_declared(node, plugin_name + ".symmetric_yaw_tolerance",
                                    rclcpp::ParameterValue(false));
  node->get_parameter(plugin_name + ".symmetric_yaw_tolerance", symmetric_yaw_tolerance_);
  xy_goal_tolerance_sq_ = xy_goal_tolerance_ * xy_goal_tolerance_;
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

void SimpleGoalChecker::reset() {
  check_xy_ = true;
}

bool SimpleGoalChecker::isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                                      const geometry_msgs::msg::Pose& goal_pose,
                                      const geometry_msgs::msg::Twist&) {
  if (check_xy_) {
    const double dx = query_pose.position.x - goal_pose.position.x;
    const double dy = query_pose.position.y - goal_pose.position.y;
    if (dx * dx + dy * dy > xy_goal_tolerance_sq_) return false;
    check_xy_ = !stateful_;
  }
  const double turn = angles::shortest_angular_distance(tf2::getYaw(query_pose.orientation),
                                                        tf2::getYaw(goal_pose.orientation));
  const double least =
      symmetric_yaw_tolerance_ ? std::min(std::abs(turn), M_PI - std::abs(turn)) : std::abs(turn);
  return least <= yaw_goal_tolerance_;
}

bool SimpleGoalChecker::getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                                      geometry_msgs::msg::Twist& vel_tolerance) {
  const double none = std::numeric_limits<double>::lowest();
  pose_tolerance.position.x = xy_goal_tolerance_;
  pose_tolerance.position.y = xy_goal_tolerance_;
  pose_tolerance.position.z = none;
  pose_tolerance.orientation =
      nav2_util::geometry_utils::orientationAroundZAxis(yaw_goal_tolerance_);
  vel_tolerance.linear.x = vel_tolerance.linear.y = vel_tolerance.linear.z = none;
  vel_tolerance.angular.x = vel_tolerance.angular.y = vel_tolerance.angular.z = none;
  return true;
}

rcl_interfaces::msg::SetParametersResult SimpleGoalChecker::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      if (name == plugin_name_ + ".xy_goal_tolerance") {
        xy_goal_tolerance_ = parameter.as_double();
        xy_goal_tolerance_sq_ = xy_goal_tolerance_ * xy_goal_tolerance_;
      }
      if (name == plugin_name_ + ".yaw_goal_tolerance") {
        yaw_goal_tolerance_ = parameter.as_double();
      }
    } else if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) {
      if (name == plugin_name_ + ".stateful") stateful_ = parameter.as_bool();
      if (name == plugin_name_ + ".symmetric_yaw_tolerance") {
        symmetric_yaw_tolerance_ = parameter.as_bool();
      }
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

}  // namespace nav2_controller

PLUGINLIB_EXPORT_CLASS(nav2_controller::SimpleGoalChecker, nav2_core::GoalChecker)
