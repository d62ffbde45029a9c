// The parameters of the controller.
#include <vector>

#include "nav2_regulated_pure_pursuit_controller/regulated_pure_pursuit_controller.hpp"
#include "nav2_util/node_utils.hpp"

namespace nav2_regulated_pure_pursuit_controller {
namespace {

struct NumberRow {
  const char* name;
  double Parameters::*value;
};
constexpr NumberRow kNumbers[] = {
    {"desired_linear_vel", &Parameters::desired_linear_vel},
    {"lookahead_dist", &Parameters::lookahead_dist},
    {"min_lookahead_dist", &Parameters::min_lookahead_dist},
    {"max_lookahead_dist", &Parameters::max_lookahead_dist},
    {"lookahead_time", &Parameters::lookahead_time},
    {"rotate_to_heading_angular_vel", &Parameters::rotate_to_heading_angular_vel},
    {"transform_tolerance", &Parameters::transform_tolerance},
    {"min_approach_linear_velocity", &Parameters::min_approach_linear_velocity},
    {"approach_velocity_scaling_dist", &Parameters::approach_velocity_scaling_dist},
    {"max_allowed_time_to_collision_up_to_carrot",
     &Parameters::max_allowed_time_to_collision_up_to_carrot},
    {"cost_scaling_dist", &Parameters::cost_scaling_dist},
    {"cost_scaling_gain", &Parameters::cost_scaling_gain},
    {"inflation_cost_scaling_factor", &Parameters::inflation_cost_scaling_factor},
    {"regulated_linear_scaling_min_radius", &Parameters::regulated_linear_scaling_min_radius},
    {"regulated_linear_scaling_min_speed", &Parameters::regulated_linear_scaling_min_speed},
    {"curvature_lookahead_dist", &Parameters::curvature_lookahead_dist},
    {"rotate_to_heading_min_angle", &Parameters::rotate_to_heading_min_angle},
    {"max_angular_accel", &Parameters::max_angular_accel},
    {"cancel_deceleration", &Parameters::cancel_deceleration},
    {"max_robot_pose_search_dist", &Parameters::max_robot_pose_search_dist},
};

struct SwitchRow {
  const char* name;
  bool Parameters::*value;
};
constexpr SwitchRow kSwitches[] = {
    {"use_velocity_scaled_lookahead_dist", &Parameters::use_velocity_scaled_lookahead_dist},
    {"use_regulated_linear_velocity_scaling", &Parameters::use_regulated_linear_velocity_scaling},
    {"use_cost_regulated_linear_velocity_scaling",
     &Parameters::use_cost_regulated_linear_velocity_scaling},
    {"use_fixed_curvature_lookahead", &Parameters::use_fixed_curvature_lookahead},
    {"use_rotate_to_heading", &Parameters::use_rotate_to_heading},
    {"use_cancel_deceleration", &Parameters::use_cancel_deceleration},
    {"allow_reversing", &Parameters::allow_reversing},
    {"interpolate_curvature_after_goal", &Parameters::interpolate_curvature_after_goal},
    {"use_collision_detection", &Parameters::use_collision_detection},
    {"stateful", &Parameters::stateful},
};

}  // namespace

void RegulatedPurePursuitController::readParameters() {
  const auto node = node_.lock();
  const auto read = [&](const char* name, auto& value) {
    const std::string full = plugin_name_ + "." + name;
    nav2_util::declare_parameter_if_not_declared(node, full, rclcpp::ParameterValue(value));
    node->get_parameter(full, value);
  };
  const double half_costmap = costmap_->getSizeInMetersX() / 2.0;
  params_.max_robot_pose_search_dist = half_costmap;
  for (const NumberRow& row : kNumbers) read(row.name, params_.*row.value);
  for (const SwitchRow& row : kSwitches) read(row.name, params_.*row.value);
  params_.base_desired_linear_vel = params_.desired_linear_vel;
  if (params_.approach_velocity_scaling_dist > half_costmap) {
    RCLCPP_WARN(logger_,
                "approach_velocity_scaling_dist is larger than forward costmap extent, leading to "
                "permanent slowdown");
  }
  if (params_.max_robot_pose_search_dist < 0.0) {
    RCLCPP_WARN(logger_,
                "Max robot search distance is negative, setting to max to search every point on "
                "path for the closest value.");
    params_.max_robot_pose_search_dist = std::numeric_limits<double>::max();
  }
  if (!params_.use_fixed_curvature_lookahead && params_.interpolate_curvature_after_goal) {
    RCLCPP_WARN(logger_,
                "For interpolate_curvature_after_goal to be set to true, "
                "use_fixed_curvature_lookahead should be true, it is currently set to false. "
                "Disabling.");
    params_.interpolate_curvature_after_goal = false;
  }
  if (params_.inflation_cost_scaling_factor <= 0.0) {
    RCLCPP_WARN(logger_,
                "The value inflation_cost_scaling_factor is incorrectly set, it should be >0. "
                "Disabling cost regulated linear velocity scaling.");
    params_.use_cost_regulated_linear_velocity_scaling = false;
  }
  dyn_params_handler_ =
      node->add_on_set_parameters_callback([this](std::vector<rclcpp::Parameter> parameters) {
        return dynamicParametersCallback(parameters);
      });
}

rcl_interfaces::msg::SetParametersResult RegulatedPurePursuitController::dynamicParametersCallback(
    std::vector<rclcpp::Parameter> parameters) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const rclcpp::Parameter& parameter : parameters) {
    const std::string& name = parameter.get_name();
    if (name == plugin_name_ + ".inflation_cost_scaling_factor" &&
        parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE &&
        parameter.as_double() <= 0.0) {
      RCLCPP_WARN(logger_,
                  "The value inflation_cost_scaling_factor is incorrectly set, it should be >0. "
                  "Ignoring parameter update.");
      continue;
    }
    if (name == plugin_name_ + ".allow_reversing" && params_.use_rotate_to_heading &&
        parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL && parameter.as_bool()) {
      RCLCPP_WARN(logger_,
                  "Both use_rotate_to_heading and allow_reversing parameter cannot be set to true. "
                  "Rejecting parameter update.");
      continue;
    }
    if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE) {
      for (const NumberRow& row : kNumbers) {
        if (name == plugin_name_ + "." + row.name) params_.*row.value = parameter.as_double();
      }
      if (name == plugin_name_ + ".desired_linear_vel") {
        params_.base_desired_linear_vel = parameter.as_double();
      }
    } else if (parameter.get_type() == rclcpp::ParameterType::PARAMETER_BOOL) {
      for (const SwitchRow& row : kSwitches) {
        if (name == plugin_name_ + "." + row.name) params_.*row.value = parameter.as_bool();
      }
    }
  }
  rcl_interfaces::msg::SetParametersResult result;
  result.successful = true;
  return result;
}

}  // namespace nav2_regulated_pure_pursuit_controller
