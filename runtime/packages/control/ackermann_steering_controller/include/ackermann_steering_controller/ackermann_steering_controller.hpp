// Drives a base with two driven and two steered wheels.
#pragma once

#include <memory>

#include "ros2wasm_parameters/parameters.hpp"
#include "steering_controllers_library/steering_controllers_library.hpp"

namespace ackermann_steering_controller {

/// Lengths in metres.
struct Params {
  double front_wheel_track = 0.0;  ///< deprecated
  double steering_track_width = 0.0;
  double rear_wheel_track = 0.0;  ///< deprecated
  double traction_track_width = 0.0;
  double wheelbase = 0.0;
  double traction_wheels_radius = 0.0;
  double front_wheels_radius = 0.0;  ///< deprecated
  double rear_wheels_radius = 0.0;   ///< deprecated
};

class AckermannSteeringController
    : public steering_controllers_library::SteeringControllersLibrary {
 public:
  controller_interface::CallbackReturn configure_odometry() override;
  void initialize_implementation_parameter_listener() override;

 protected:
  std::shared_ptr<ros2wasm_parameters::ParameterListener<Params>> ackermann_param_listener_;
  Params ackermann_params_;
};

}  // namespace ackermann_steering_controller
