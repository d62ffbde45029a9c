// See diff_drive_parameters.hpp.
#include "diff_drive_controller/diff_drive_parameters.hpp"

namespace diff_drive_controller {
namespace {

using ros2wasm_parameters::Declarations;
using ros2wasm_parameters::fixed_size;
using ros2wasm_parameters::gt;
using ros2wasm_parameters::gt_eq_or_nan;
using ros2wasm_parameters::lt_eq_or_nan;
using ros2wasm_parameters::not_empty;
using Names = std::vector<std::string>;

constexpr char kDeprecated[] = "deprecated, set the respective limits to ``.NAN``";

void describe_axis(Declarations& of, const std::string& axis, AxisLimits& limits) {
  of.add(axis + "has_velocity_limits", limits.has_velocity_limits, {kDeprecated});
  of.add(axis + "has_acceleration_limits", limits.has_acceleration_limits, {kDeprecated});
  of.add(axis + "has_jerk_limits", limits.has_jerk_limits, {kDeprecated});
  of.add(axis + "max_velocity", limits.max_velocity, {""}, {gt_eq_or_nan(0.0)});
  of.add(axis + "min_velocity", limits.min_velocity, {""}, {lt_eq_or_nan(0.0)});
  of.add(axis + "max_acceleration", limits.max_acceleration, {"Greatest gain of speed, forwards."},
         {gt_eq_or_nan(0.0)});
  of.add(axis + "max_deceleration", limits.max_deceleration, {"Greatest loss of speed, forwards."},
         {lt_eq_or_nan(0.0)});
  of.add(axis + "min_acceleration", limits.min_acceleration, {"deprecated, use max_deceleration"});
  of.add(axis + "max_acceleration_reverse", limits.max_acceleration_reverse,
         {"Greatest gain of speed, backwards; -max_acceleration when it is not set."},
         {lt_eq_or_nan(0.0)});
  of.add(axis + "max_deceleration_reverse", limits.max_deceleration_reverse,
         {"Greatest loss of speed, backwards; -max_deceleration when it is not set."},
         {gt_eq_or_nan(0.0)});
  of.add(axis + "max_jerk", limits.max_jerk, {""}, {gt_eq_or_nan(0.0)});
  of.add(axis + "min_jerk", limits.min_jerk, {""}, {lt_eq_or_nan(0.0)});
}

void describe_wheels(Declarations& of, Params& params) {
  of.add("left_wheel_names", params.left_wheel_names, {"Joints of the wheels on the left"},
         {not_empty<Names>()});
  of.add("right_wheel_names", params.right_wheel_names, {"Joints of the wheels on the right"},
         {not_empty<Names>()});
  of.add("wheel_separation", params.wheel_separation,
         {"Distance between the left and the right wheels [m]."}, {gt(0.0)});
  of.add("wheel_radius", params.wheel_radius, {"Radius of a wheel [m]."}, {gt(0.0)});
  of.add("wheel_separation_multiplier", params.wheel_separation_multiplier,
         {"Correction of ``wheel_separation``."});
  of.add("left_wheel_radius_multiplier", params.left_wheel_radius_multiplier,
         {"Correction of ``wheel_radius`` on the left."});
  of.add("right_wheel_radius_multiplier", params.right_wheel_radius_multiplier,
         {"Correction of ``wheel_radius`` on the right."});
}

}  // namespace

void describe(Declarations& of, Params& params) {
  describe_wheels(of, params);
  of.add("tf_frame_prefix_enable", params.tf_frame_prefix_enable,
         {"Put a prefix before the names of frames?"});
  of.add("tf_frame_prefix", params.tf_frame_prefix,
         {"The prefix; when it is empty, the namespace of the controller."});
  of.add("odom_frame_id", params.odom_frame_id, {"The frame of the odometry."});
  of.add("base_frame_id", params.base_frame_id, {"The frame of the base."});
  of.add("pose_covariance_diagonal", params.pose_covariance_diagonal,
         {"Covariance of the pose: x, y, z, roll, pitch, yaw."},
         {fixed_size<std::vector<double>>(6)});
  of.add("twist_covariance_diagonal", params.twist_covariance_diagonal,
         {"Covariance of the speed, in the same order."}, {fixed_size<std::vector<double>>(6)});
  of.add("open_loop", params.open_loop,
         {"Compute the odometry from the commands instead of the wheels?"});
  of.add("position_feedback", params.position_feedback,
         {"Do the wheels report positions, not speeds?"});
  of.add("enable_odom_tf", params.enable_odom_tf,
         {"Publish the transform from ``odom_frame_id`` to ``base_frame_id``?"});
  of.add("cmd_vel_timeout", params.cmd_vel_timeout,
         {"Seconds after which the base stops without a new command; 0: never."});
  of.add("publish_limited_velocity", params.publish_limited_velocity,
         {"Publish the command after the limits?"});
  of.add("velocity_rolling_window_size", params.velocity_rolling_window_size,
         {"Number of values in the mean of the speed."});
  of.add("publish_rate", params.publish_rate, {"Rate of the odometry and the transform [Hz]."});
  describe_axis(of, "linear.x.", params.linear.x);
  describe_axis(of, "angular.z.", params.angular.z);
}

}  // namespace diff_drive_controller
