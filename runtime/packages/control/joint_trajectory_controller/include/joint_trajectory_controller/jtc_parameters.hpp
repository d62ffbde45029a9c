// The parameters of JointTrajectoryController.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "ros2wasm_parameters/parameters.hpp"

namespace joint_trajectory_controller {

struct Params {
  std::vector<std::string> joints;
  std::vector<std::string> command_joints;
  std::vector<std::string> command_interfaces;
  std::vector<std::string> state_interfaces;
  struct SpeedScaling {
    double initial_scaling_factor = 1.0;
    std::string state_interface;
    std::string command_interface;
  } speed_scaling;
  bool allow_partial_joints_goal = false;
  bool open_loop_control = false;  ///< deprecated
  bool interpolate_from_desired_state = false;
  bool allow_integration_in_goal_trajectories = false;
  bool set_last_command_interface_value_as_state_on_activation = true;
  double action_monitor_rate = 20.0;
  std::string interpolation_method = "splines";
  bool allow_nonzero_velocity_at_trajectory_end = false;
  double cmd_timeout = 0.0;

  struct Gains {
    double p = 0.0;
    double i = 0.0;
    double d = 0.0;
    double i_clamp = std::numeric_limits<double>::infinity();
    double i_clamp_max = std::numeric_limits<double>::infinity();
    double i_clamp_min = -std::numeric_limits<double>::infinity();
    double ff_velocity_scale = 0.0;
    double u_clamp_max = std::numeric_limits<double>::infinity();
    double u_clamp_min = -std::numeric_limits<double>::infinity();
    std::string antiwindup_strategy = "legacy";
    double tracking_time_constant = 0.0;
    double error_deadband = 0.0;
  };
  std::map<std::string, Gains> gains;  ///< by joint

  struct JointConstraints {
    double trajectory = 0.0;
    double goal = 0.0;
    double max_deceleration_on_cancel = 0.0;
  };
  struct Constraints {
    double stopped_velocity_tolerance = 0.01;
    double goal_time = 0.0;
    bool decelerate_on_cancel = false;
    std::map<std::string, JointConstraints> joints;
  } constraints;
};

using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

void describe(ros2wasm_parameters::Declarations& of, Params& params);

}  // namespace joint_trajectory_controller
