// See steering_parameters.hpp.
#include "steering_controllers_library/steering_parameters.hpp"

namespace steering_controllers_library {

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  using ros2wasm_parameters::kReadOnly;
  using Names = std::vector<std::string>;
  const std::vector<ros2wasm_parameters::Rule<Names>> names = {
      ros2wasm_parameters::size_lt<Names>(5), ros2wasm_parameters::unique<Names>()};
  const std::vector<ros2wasm_parameters::Rule<std::vector<double>>> six = {
      ros2wasm_parameters::fixed_size<std::vector<double>>(6)};
  const char* const older =
      "DEPRECATED: Use 'traction_joints_names' or 'steering_joints_names' instead";
  const char* const older_state =
      "DEPRECATED: Use 'traction_joints_state_names' or 'steering_joints_state_names' instead";

  of.add("reference_timeout", params.reference_timeout,
         {"Seconds after which the base stops without a new reference; 0: each counts once."});
  of.add("front_steering", params.front_steering, {older, kReadOnly});
  of.add("rear_wheels_names", params.rear_wheels_names, {older, kReadOnly}, names);
  of.add("traction_joints_names", params.traction_joints_names,
         {"Joints of the driven wheels; of two, the right one first.", kReadOnly}, names);
  of.add("front_wheels_names", params.front_wheels_names, {older, kReadOnly}, names);
  of.add("steering_joints_names", params.steering_joints_names,
         {"Joints that steer; of two, the right one first.", kReadOnly}, names);
  of.add("traction_joints_state_names", params.traction_joints_state_names,
         {"Joints with the states of the driven wheels, when others.", kReadOnly}, names);
  of.add("rear_wheels_state_names", params.rear_wheels_state_names, {older_state, kReadOnly},
         names);
  of.add("steering_joints_state_names", params.steering_joints_state_names,
         {"Joints with the states of the steering, when others.", kReadOnly}, names);
  of.add("front_wheels_state_names", params.front_wheels_state_names, {older_state, kReadOnly},
         names);
  of.add("open_loop", params.open_loop,
         {"Compute the odometry from the references instead of the wheels?"});
  of.add("reduce_wheel_speed_until_steering_reached",
         params.reduce_wheel_speed_until_steering_reached,
         {"Drive slower until the steering is where it shall be?"});
  of.add("velocity_rolling_window_size", params.velocity_rolling_window_size,
         {"Number of values in the mean of the speed."});
  of.add("base_frame_id", params.base_frame_id, {"The frame of the base."});
  of.add("odom_frame_id", params.odom_frame_id, {"The frame of the odometry."});
  of.add("enable_odom_tf", params.enable_odom_tf, {"Publish the transform of the base?"});
  of.add("twist_covariance_diagonal", params.twist_covariance_diagonal,
         {"Covariance of the speed: x, y, z, roll, pitch, yaw."}, six);
  of.add("pose_covariance_diagonal", params.pose_covariance_diagonal,
         {"Covariance of the pose, in the same order."}, six);
  of.add("position_feedback", params.position_feedback,
         {"Do the driven wheels report positions, not speeds?"});
}

}  // namespace steering_controllers_library
