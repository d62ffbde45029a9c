// See bicycle_steering_controller.hpp.
#include "bicycle_steering_controller/bicycle_steering_controller.hpp"

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace bicycle_steering_controller {
namespace {

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("wheelbase", params.wheelbase, {"Distance between front and rear wheels."},
         {ros2wasm_parameters::gt(0.0)});
  of.add("traction_wheel_radius", params.traction_wheel_radius, {"Radius of the driven wheel."});
  of.add("front_wheel_radius", params.front_wheel_radius,
         {"DEPRECATED: use 'traction_wheel_radius'", ros2wasm_parameters::kReadOnly});
  of.add("rear_wheel_radius", params.rear_wheel_radius,
         {"DEPRECATED: use 'traction_wheel_radius'", ros2wasm_parameters::kReadOnly});
}

}  // namespace

using controller_interface::CallbackReturn;

void BicycleSteeringController::initialize_implementation_parameter_listener() {
  bicycle_param_listener_ =
      std::make_shared<ros2wasm_parameters::ParameterListener<Params>>(get_node(), describe);
}

CallbackReturn BicycleSteeringController::configure_odometry() {
  Params& params = bicycle_params_;
  params = bicycle_param_listener_->get_params();
  const auto logger = get_node()->get_logger();
  if (params.front_wheel_radius > 0.0) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'front_wheel_radius', set 'traction_wheel_radius' instead");
    params.traction_wheel_radius = params.front_wheel_radius;
  }
  if (params.rear_wheel_radius > 0.0) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'rear_wheel_radius', set 'traction_wheel_radius' instead");
    params.traction_wheel_radius = params.rear_wheel_radius;
  }
  if (params.traction_wheel_radius <= 0.0) {
    RCLCPP_FATAL(logger, "parameter 'traction_wheel_radius' is not set, cannot configure odometry");
    return CallbackReturn::ERROR;
  }
  odometry_.set_wheel_params(params.traction_wheel_radius, params.wheelbase);
  odometry_.set_odometry_type(steering_kinematics::BICYCLE_CONFIG);
  RCLCPP_INFO(logger, "bicycle odometry configure successful");
  return CallbackReturn::SUCCESS;
}

}  // namespace bicycle_steering_controller

PLUGINLIB_EXPORT_CLASS(bicycle_steering_controller::BicycleSteeringController,
                       controller_interface::ChainableControllerInterface)
