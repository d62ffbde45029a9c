// Drives a base with two driven wheels and one that steers.
#pragma once

#include <memory>

#include "ros2wasm_parameters/parameters.hpp"
#include "steering_controllers_library/steering_controllers_library.hpp"

namespace tricycle_steering_controller {

/// Lengths in metres.
struct Params {
  double wheel_track = 0.0;  ///< deprecated
  double traction_track_width = 0.0;
  double wheelbase = 0.0;
  double traction_wheels_radius = 0.0;
  double front_wheels_radius = 0.0;  ///< deprecated
  double rear_wheels_radius = 0.0;   ///< deprecated
};

class TricycleSteeringController : public steering_controllers_library::SteeringControllersLibrary {
 public:
  controller_interface::CallbackReturn configure_odometry() override;
  void initialize_implementation_parameter_listener() override;

 protected:
  std::shared_ptr<ros2wasm_parameters::ParameterListener<Params>> tricycle_param_listener_;
  Params tricycle_params_;
};

}  // namespace tricycle_steering_controller
