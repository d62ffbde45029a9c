// Drives a base with one driven and one steered wheel.
#pragma once

#include <memory>

#include "ros2wasm_parameters/parameters.hpp"
#include "steering_controllers_library/steering_controllers_library.hpp"

namespace bicycle_steering_controller {

/// Lengths in metres.
struct Params {
  double wheelbase = 0.0;
  double traction_wheel_radius = 0.0;
  double front_wheel_radius = 0.0;  ///< deprecated
  double rear_wheel_radius = 0.0;   ///< deprecated
};

class BicycleSteeringController : public steering_controllers_library::SteeringControllersLibrary {
 public:
  controller_interface::CallbackReturn configure_odometry() override;
  void initialize_implementation_parameter_listener() override;

 protected:
  std::shared_ptr<ros2wasm_parameters::ParameterListener<Params>> bicycle_param_listener_;
  Params bicycle_params_;
};

}  // namespace bicycle_steering_controller
