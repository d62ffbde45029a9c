// The parameters of all controllers of steered bases.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ros2wasm_parameters/parameters.hpp"

namespace steering_controllers_library {

struct Params {
  double reference_timeout = 1.0;
  bool front_steering = true;  ///< deprecated, as all names of front and rear wheels
  std::vector<std::string> rear_wheels_names;
  std::vector<std::string> traction_joints_names;
  std::vector<std::string> front_wheels_names;
  std::vector<std::string> steering_joints_names;
  std::vector<std::string> traction_joints_state_names;
  std::vector<std::string> rear_wheels_state_names;
  std::vector<std::string> steering_joints_state_names;
  std::vector<std::string> front_wheels_state_names;
  bool open_loop = false;
  bool reduce_wheel_speed_until_steering_reached = false;
  int64_t velocity_rolling_window_size = 10;
  std::string base_frame_id = "base_link";
  std::string odom_frame_id = "odom";
  bool enable_odom_tf = true;
  std::vector<double> twist_covariance_diagonal = {0.0, 7.0, 14.0, 21.0, 28.0, 35.0};
  std::vector<double> pose_covariance_diagonal = {0.0, 7.0, 14.0, 21.0, 28.0, 35.0};
  bool position_feedback = false;
};

using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

void describe(ros2wasm_parameters::Declarations& of, Params& params);

}  // namespace steering_controllers_library
