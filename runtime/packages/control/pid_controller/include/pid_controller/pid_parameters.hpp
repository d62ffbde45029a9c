// The parameters of PidController.
#pragma once

#include <limits>
#include <map>
#include <string>
#include <vector>

#include "ros2wasm_parameters/parameters.hpp"

namespace pid_controller {

struct Params {
  std::vector<std::string> dof_names;
  std::vector<std::string> reference_and_state_dof_names;
  std::string command_interface;
  std::vector<std::string> reference_and_state_interfaces;
  bool set_current_state_as_first_setpoint = true;
  bool use_external_measured_states = false;
  bool enable_feedforward = false;

  struct Gains {
    double p = 0.0;
    double i = 0.0;
    double d = 0.0;
    double u_clamp_max = std::numeric_limits<double>::infinity();
    double u_clamp_min = -std::numeric_limits<double>::infinity();
    bool antiwindup = false;
    double i_clamp_max = std::numeric_limits<double>::infinity();
    double i_clamp_min = -std::numeric_limits<double>::infinity();
    std::string antiwindup_strategy = "legacy";
    double tracking_time_constant = 0.0;
    double error_deadband = 1e-16;
    double feedforward_gain = 0.0;
    bool angle_wraparound = false;
    bool save_i_term = true;
    bool activate_state_publisher = false;
  };
  std::map<std::string, Gains> gains;  ///< by degree of freedom
};

using ParamListener = ros2wasm_parameters::ParameterListener<Params>;

void describe(ros2wasm_parameters::Declarations& of, Params& params);

}  // namespace pid_controller
