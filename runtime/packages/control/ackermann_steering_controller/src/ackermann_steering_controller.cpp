// See ackermann_steering_controller.hpp.
#include "ackermann_steering_controller/ackermann_steering_controller.hpp"

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace ackermann_steering_controller {
namespace {

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  const char* const older = "DEPRECATED: use 'traction_track_width' or 'steering_track_width'";
  of.add("front_wheel_track", params.front_wheel_track, {older});
  of.add("steering_track_width", params.steering_track_width,
         {"Distance between the steered wheels; 'traction_track_width' when it is not set."});
  of.add("rear_wheel_track", params.rear_wheel_track, {older});
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

void AckermannSteeringController::initialize_implementation_parameter_listener() {
  ackermann_param_listener_ =
      std::make_shared<ros2wasm_parameters::ParameterListener<Params>>(get_node(), describe);
}

CallbackReturn AckermannSteeringController::configure_odometry() {
  Params& params = ackermann_params_;
  params = ackermann_param_listener_->get_params();
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
  if (params.front_wheel_track > 0.0) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'front_wheel_track', set 'traction_track_width' or "
                "'steering_track_width' instead");
    (params_.front_steering ? params.steering_track_width : params.traction_track_width) =
        params.front_wheel_track;
  }
  if (params.rear_wheel_track > 0.0) {
    RCLCPP_WARN(logger,
                "DEPRECATED parameter 'rear_wheel_track', set 'traction_track_width' or "
                "'steering_track_width' instead");
    (params_.front_steering ? params.traction_track_width : params.steering_track_width) =
        params.rear_wheel_track;
  }
  if (params.traction_wheels_radius <= 0.0) {
    RCLCPP_FATAL(logger,
                 "parameter 'traction_wheels_radius' is not set, cannot configure odometry");
    return CallbackReturn::ERROR;
  }
  if (params.steering_track_width <= 0.0) {
    params.steering_track_width = params.traction_track_width;
  }
  odometry_.set_wheel_params(params.traction_wheels_radius, params.wheelbase,
                             params.steering_track_width, params.traction_track_width);
  odometry_.set_odometry_type(steering_kinematics::ACKERMANN_CONFIG);
  RCLCPP_INFO(logger, "Ackermann odom configure successful");
  return CallbackReturn::SUCCESS;
}

}  // namespace ackermann_steering_controller

PLUGINLIB_EXPORT_CLASS(ackermann_steering_controller::AckermannSteeringController,
                       controller_interface::ChainableControllerInterface)
