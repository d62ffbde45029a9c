// The cycle of DiffDriveController: command, limits, odometry, wheels.
#include "diff_drive_controller/diff_drive_controller.hpp"

#include <cmath>
#include <limits>

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"
#include "tf2/LinearMath/Quaternion.h"

namespace diff_drive_controller {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr int kThrottleMs = 1000;

}  // namespace

using controller_interface::return_type;

return_type DiffDriveController::update_reference_from_subscribers(const rclcpp::Time& time,
                                                                   const rclcpp::Duration&) {
  const auto logger = get_node()->get_logger();
  if (last_update_ && last_update_->get_clock_type() == time.get_clock_type() &&
      time < *last_update_) {
    // Simulated time was set back: by its stamp a command of before would hold until then.
    halt();
    reset_buffers();
  }
  last_update_ = time;
  if (const auto newest = received_velocity_msg_.try_get()) command_msg_ = *newest;
  auto& linear = *ordered_exported_reference_interfaces_[0];
  auto& angular = *ordered_exported_reference_interfaces_[1];
  const rclcpp::Duration age = time - command_msg_.header.stamp;
  bool is_set = true;
  if (cmd_vel_timeout_.nanoseconds() != 0 && age > cmd_vel_timeout_) {
    is_set = linear.set_value(0.0) && angular.set_value(0.0);
    RCLCPP_WARN_THROTTLE(logger, *get_node()->get_clock(), kThrottleMs,
                         "Velocity command timed out. Braking.");
  } else if (std::isfinite(command_msg_.twist.linear.x) &&
             std::isfinite(command_msg_.twist.angular.z)) {
    is_set = linear.set_value(command_msg_.twist.linear.x) &&
             angular.set_value(command_msg_.twist.angular.z);
  } else {
    RCLCPP_WARN_SKIPFIRST_THROTTLE(
        logger, *get_node()->get_clock(), kThrottleMs,
        "Command message contains NaNs. Not updating reference interfaces.");
  }
  if (!is_set) RCLCPP_DEBUG(logger, "Unable to set the reference interfaces!");
  return return_type::OK;
}

return_type DiffDriveController::update_and_write_commands(const rclcpp::Time& time,
                                                           const rclcpp::Duration& period) {
  double linear =
      ordered_exported_reference_interfaces_[0]->get_optional<double>().value_or(kNotANumber);
  double angular =
      ordered_exported_reference_interfaces_[1]->get_optional<double>().value_or(kNotANumber);
  if (!std::isfinite(linear) || !std::isfinite(angular)) {
    // No command yet. The time until the first one does not count as driven.
    if (params_.open_loop) odometry_.init(time.nanoseconds());
    return return_type::OK;
  }
  return_type result = return_type::OK;
  const double period_s = period.seconds();
  limiter_linear_->limit(linear, last_linear_[0], last_linear_[1], period_s);
  limiter_angular_->limit(angular, last_angular_[0], last_angular_[1], period_s);
  last_linear_ = {linear, last_linear_[0]};
  last_angular_ = {angular, last_angular_[0]};

  if (!update_odometry(linear, angular, time, period_s, result)) return result;
  if (is_time_to_publish(time)) publish_odometry(time);
  if (params_.publish_limited_velocity && limited_velocity_publisher_) {
    limited_velocity_message_.header.stamp = time;
    limited_velocity_message_.twist.linear.x = linear;
    limited_velocity_message_.twist.angular.z = angular;
    limited_velocity_publisher_->try_publish(limited_velocity_message_);
  }
  command_wheels(linear, angular);
  return result;
}

DiffDriveController::Feedback DiffDriveController::read_side(const std::vector<WheelHandle>& wheels,
                                                             double& mean) const {
  double sum = 0.0;
  for (size_t i = 0; i < wheels.size(); ++i) {
    const auto value = wheels[i].feedback->get().get_optional();
    if (!value) return Feedback::kBusy;
    if (std::isnan(*value)) {
      RCLCPP_ERROR(get_node()->get_logger(),
                   "Either the left or right wheel %s is invalid for index [%zu]", feedback_type(),
                   i);
      return Feedback::kInvalid;
    }
    sum += *value;
  }
  mean = sum / static_cast<double>(wheels.size());
  return Feedback::kRead;
}

bool DiffDriveController::update_odometry(double linear, double angular, const rclcpp::Time& time,
                                          double period_s, return_type& result) {
  if (params_.open_loop) {
    odometry_.updateOpenLoop(linear, angular, time.nanoseconds());
    return true;
  }
  double left = 0.0;
  double right = 0.0;
  Feedback feedback = read_side(registered_left_wheel_handles_, left);
  if (feedback == Feedback::kRead) feedback = read_side(registered_right_wheel_handles_, right);
  if (feedback == Feedback::kBusy) {
    RCLCPP_DEBUG(get_node()->get_logger(),
                 "Unable to retrieve the data from the left or right wheels feedback!");
  }
  if (feedback == Feedback::kInvalid) result = return_type::ERROR;
  if (feedback != Feedback::kRead) return false;
  if (params_.position_feedback) {
    odometry_.update(left, right, time.nanoseconds());
  } else {
    odometry_.updateFromVelocity(left * wheels_.left_radius * period_s,
                                 right * wheels_.right_radius * period_s, time.nanoseconds());
  }
  return true;
}

bool DiffDriveController::is_time_to_publish(const rclcpp::Time& time) {
  if (!last_publication_ || last_publication_->get_clock_type() != time.get_clock_type() ||
      time < *last_publication_) {  // simulated time was set back
    last_publication_ = time;
    return true;
  }
  if (*last_publication_ + publish_period_ < time) {
    last_publication_ = *last_publication_ + publish_period_;
    return true;
  }
  return false;
}

void DiffDriveController::publish_odometry(const rclcpp::Time& time) {
  tf2::Quaternion orientation;
  orientation.setRPY(0.0, 0.0, odometry_.getHeading());
  geometry_msgs::msg::Quaternion rotation;
  rotation.x = orientation.x();
  rotation.y = orientation.y();
  rotation.z = orientation.z();
  rotation.w = orientation.w();
  if (odometry_publisher_) {
    odometry_message_.header.stamp = time;
    odometry_message_.pose.pose.position.x = odometry_.getX();
    odometry_message_.pose.pose.position.y = odometry_.getY();
    odometry_message_.pose.pose.orientation = rotation;
    odometry_message_.twist.twist.linear.x = odometry_.getLinear();
    odometry_message_.twist.twist.angular.z = odometry_.getAngular();
    odometry_publisher_->try_publish(odometry_message_);
  }
  if (params_.enable_odom_tf && transform_publisher_) {
    auto& transform = transform_message_.transforms.front();
    transform.header.stamp = time;
    transform.transform.translation.x = odometry_.getX();
    transform.transform.translation.y = odometry_.getY();
    transform.transform.rotation = rotation;
    transform_publisher_->try_publish(transform_message_);
  }
}

void DiffDriveController::command_wheels(double linear, double angular) {
  const WheelSpeeds speeds = wheel_speeds(linear, angular, wheels_);
  bool is_set = true;
  for (WheelHandle& wheel : registered_left_wheel_handles_) {
    is_set &= wheel.velocity.get().set_value(speeds.left);
  }
  for (WheelHandle& wheel : registered_right_wheel_handles_) {
    is_set &= wheel.velocity.get().set_value(speeds.right);
  }
  if (!is_set) {
    RCLCPP_DEBUG(get_node()->get_logger(),
                 "Unable to set the command to one of the command handles!");
  }
}

}  // namespace diff_drive_controller

PLUGINLIB_EXPORT_CLASS(diff_drive_controller::DiffDriveController,
                       controller_interface::ChainableControllerInterface)
