// See position_goal_checker.hpp.
#include "nav2_controller/plugins/position_goal_checker.hpp"

#include <limits>

#include "nav2_util/node_utils.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_controller {

using nav2_util::declare_parameter_if_not_declared;

void PositionGoalChecker::initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                                     const std::string& plugin_name,
                                     const std::shared_ptr<nav2_costmap_2d::Costmap2DROS>) {
  plugin_name_ = plugin_name;
  const auto node = parent.lock();
  declare_parameter_if_not_declared(node, plugin_name + ".xy_goal_tolerance",
                                    rclcpp::ParameterValue(0.25));
  declare_parameter_if_not_declared(node, plugin_name + ".stateful", rclcpp::ParameterValue(true));
  double tolerance = 0;
  node->get_parameter(plugin_name + ".xy_goal_tolerance", tolerance);
  setXYGoalTolerance(tolerance);
  node->get_parameter(plugin_name + ".stateful", stateful_);
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

void PositionGoalChecker::reset() {
  position_reached_ = false;
}

bool PositionGoalChecker::isGoalReached(const geometry_msgs::msg::Pose& query_pose,
                                        const geometry_msgs::msg::Pose& goal_pose,
                                        const geometry_msgs::msg::Twist&) {
  if (position_reached_) return true;
  const double dx = query_pose.position.x - goal_pose.position.x;
  const double dy = query_pose.position.y - goal_pose.position.y;
  const bool reached = dx * dx + dy * dy <= xy_goal_tolerance_sq_;
  position_reached_ = reached && stateful_;
  return reached;
}

bool PositionGoalChecker::getTolerances(geometry_msgs::msg::Pose& pose_tolerance,
                                        geometry_msgs::msg::Twist& vel_tolerance) {
  const double none = std::numeric_limits<double>::lowest();
  pose_tolerance.position.x = xy_goal_tolerance_;
  pose_tolerance.position.y = xy_goal_tolerance_;
  pose_tolerance.position.z = none;
  pose_tolerance.orientation = geometry_msgs::msg::Quaternion();
  vel_tolerance.linear.x = vel_tolerance.linear.y = vel_tolerance.linear.z = none;
  vel_tolerance.angular.x = vel_tolerance.angular.y = vel_tolerance.angular.z = none;
  return true;
}

void PositionGoalChecker::setXYGoalTolerance(double tolerance) {
  xy_goal_tolerance_ = tolerance;
  xy_goal_tolerance_sq_ = tolerance * tolerance;
}

rcl_interfaces::msg::SetParametersResult PositionGoalChecker::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    const auto type = parameter.get_type();
    if (name == plugin_name_ + ".xy_goal_tolerance" &&
        type == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      setXYGoalTolerance(parameter.as_double());
    } else if (name == plugin_name_ + ".stateful" &&
               type == rclcpp::ParameterType::PARAMETER_BOOL) {
      stateful_ = parameter.as_bool();
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

}  // namespace nav2_controller

PLUGINLIB_EXPORT_CLASS(nav2_controller::PositionGoalChecker, nav2_core::GoalChecker)
