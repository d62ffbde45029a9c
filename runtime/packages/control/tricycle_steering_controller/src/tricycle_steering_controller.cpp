// See tricycle_steering_controller.hpp.
#include "tricycle_steering_controller/tricycle_steering_controller.hpp"

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace tricycle_steering_controller {
namespace {

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("wheel_track", params.wheel_track, {"(deprecated) use 'traction_track_width' instead"});
  of.add("traction_track_width", params.traction_track_width,
         {"Distance between the driven wheels."});
  of.add("wheelbase", params.wheelbase, {"Distance between front and rear wheels."},
         {ros2wasm_parameters::gt(0.0)});
  of.add("traction_wheels_radius", params.traction_wheels_radius, {"Radius of the driven wheels."});
  of.add("front_wheels_radius", params.front_wheels_radius,
         {"DEPRECATED: use 'traction_wheels_radius'"});
  of.add("rear_wheels_radius", params.rear_wheels_radius,
         {"DEPRECATED: use 'traction_wheels_radius'"});
}

}  // namespace

using controller_interface::CallbackReturn;

void TricycleSteeringController::initialize_implementation_parameter_listener() {
  tricycle_param_listener_ =
      std::make_shared<ros2wasm_parameters::ParameterListener<Params>>(get_node(), describe);
}

CallbackReturn TricycleSteeringController::configure_odometry() {
  Params& params = tricycle_params_;
  params = tricycle_param_listener_->get_params();
  const auto logger = get_node()->get_logger();
  if (params.front_wheels_radius > 0.0) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'front_wheel_radius', set 'traction_wheels_radius' instead");
    params.traction_wheels_radius = params.front_wheels_radius;
  }
  if (params.rear_wheels_radius > 0.0) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'rear_wheel_radius', set 'traction_wheels_radius' instead");
    params.traction_wheels_radius = params.rear_wheels_radius;
  }
  if (params.wheel_track > 0.0) {
    RCLCPP_WARN(logger, "DEPRECATED parameter 'wheel_track', set 'traction_track_width' instead");
    params.traction_track_width = params.wheel_track;
  }
  if (params.traction_track_width <= 0.0) {
    RCLCPP_FATAL(logger, "parameter 'traction_track_width' is not set, cannot configure odometry");
    return CallbackReturn::ERROR;
  }
  if (params.traction_wheels_radius <= 0.0) {
    RCLCPP_FATAL(logger,
                 "parameter 'traction_wheels_radius' is not set, cannot configure odometry");
    return CallbackReturn::ERROR;
  }
  odometry_.set_wheel_params(params.traction_wheels_radius, params.wheelbase,
                             params.traction_track_width);
  odometry_.set_odometry_type(steering_kinematics::TRICYCLE_CONFIG);
  RCLCPP_INFO(logger, "tricycle odom configure successful");
  return CallbackReturn::SUCCESS;
}

}  // namespace tricycle_steering_controller

PLUGINLIB_EXPORT_CLASS(tricycle_steering_controller::TricycleSteeringController,
                       controller_interface::ChainableControllerInterface)
