// The parameters of DiffDriveController.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "ros2wasm_parameters/parameters.hpp"

namespace diff_drive_controller {

/// The limits of one axis; NaN: no limit, or the one of the other direction.
struct AxisLimits {
  static constexpr double kUnset = std::numeric_limits<double>::quiet_NaN();
  bool has_velocity_limits = true;  ///< deprecated, as the next two
  bool has_acceleration_limits = true;
  bool has_jerk_limits = true;
  double max_velocity = kUnset;
  double min_velocity = kUnset;
  double max_acceleration = kUnset;
  double max_deceleration = kUnset;
  double min_acceleration = kUnset;  ///< deprecated
  double max_acceleration_reverse = kUnset;
  double max_deceleration_reverse = kUnset;
  double max_jerk = kUnset;
  double min_jerk = kUnset;
};

struct Params {
  std::vector<std::string> left_wheel_names;
  std::vector<std::string> right_wheel_names;
  double wheel_separation = 0.0;
  double wheel_radius = 0.0;
  double wheel_separation_multiplier = 1.0;
  double left_wheel_radius_multiplier = 1.0;
  double right_wheel_radius_multiplier = 1.0;
  bool tf_frame_prefix_enable = true;
  std::string tf_frame_prefix;
  std::string odom_frame_id = "odom";
  std::string base_frame_id = "base_link";
  std::vector<double> pose_covariance_diagonal = std::vector<double>(6, 0.0);
  std::vector<double> twist_covariance_diagonal = std::vector<double>(6, 0.0);
  bool open_loop = false;
  bool position_feedback = true;
  bool enable_odom_tf = true;
  double cmd_vel_timeout = 0.5;
  bool publish_limited_velocity = false;
  int64_t velocity_rolling_window_size = 10;
  double publish_rate = 50.0;
  struct {
    AxisLimits x;
  } linear;
  struct {
    AxisLimits z;
  } angular;
};

using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

void describe(ros2wasm_parameters::Declarations& of, Params& params);

}  // namespace diff_drive_controller
