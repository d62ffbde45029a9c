// The cycle of controllers of steered bases.
#include "steering_controllers_library/steering_controllers_library.hpp"

#include <cmath>
#include <limits>

#include "rclcpp/logging.hpp"
#include "tf2/LinearMath/Quaternion.h"

namespace steering_controllers_library {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

using controller_interface::return_type;

void SteeringControllersLibrary::set_references(double linear, double angular) {
  if (!ordered_exported_reference_interfaces_[0]->set_value(linear) ||
      !ordered_exported_reference_interfaces_[1]->set_value(angular)) {
    RCLCPP_DEBUG(get_node()->get_logger(), "Unable to set a reference interface");
  }
}

return_type SteeringControllersLibrary::update_reference_from_subscribers(const rclcpp::Time& time,
                                                                          const rclcpp::Duration&) {
  if (last_time_ && last_time_->get_clock_type() == time.get_clock_type() && time < *last_time_) {
    // Simulated time was set back: by its stamp a reference of before would hold until then.
    current_ref_.twist.linear.x = current_ref_.twist.angular.z = kNotANumber;
    input_ref_.try_set(current_ref_);
    set_references(kNotANumber, kNotANumber);
  }
  last_time_ = time;
  if (const auto newest = input_ref_.try_get()) current_ref_ = *newest;
  double& linear = current_ref_.twist.linear.x;
  double& angular = current_ref_.twist.angular.z;
  if (!std::isfinite(linear) || !std::isfinite(angular)) return return_type::OK;
  const bool counts_once = ref_timeout_.nanoseconds() == 0;
  const bool is_too_old = !counts_once && time - current_ref_.header.stamp > ref_timeout_;
  if (is_too_old) {
    set_references(kNotANumber, kNotANumber);
  } else {
    set_references(linear, angular);
  }
  if (is_too_old || counts_once) {
    linear = angular = kNotANumber;
    input_ref_.try_set(current_ref_);
  }
  return return_type::OK;
}

return_type SteeringControllersLibrary::update_and_write_commands(const rclcpp::Time& time,
                                                                  const rclcpp::Duration& period) {
  const auto value = [this](size_t place) {
    return ordered_exported_reference_interfaces_[place]->get_optional<double>().value_or(
        kNotANumber);
  };
  const double linear = value(0);
  const double angular = value(1);
  last_linear_velocity_ = std::isfinite(linear) ? linear : 0.0;
  last_angular_velocity_ = std::isfinite(angular) ? angular : 0.0;
  update_odometry(period);
  write_commands(linear, angular);
  publish_odometry(time);
  publish_status(time);
  return return_type::OK;
}

bool SteeringControllersLibrary::update_odometry(const rclcpp::Duration& period) {
  const double dt = period.seconds();
  if (params_.open_loop) {
    odometry_.update_open_loop(last_linear_velocity_, last_angular_velocity_, dt);
    return true;
  }
  std::vector<double> states;
  for (const auto& state : state_interfaces_) {
    states.push_back(state.get_optional().value_or(kNotANumber));
    if (!std::isfinite(states.back())) return true;  // not measured yet
  }
  const bool has_positions = params_.position_feedback;
  switch (odometry_.get_odometry_type()) {
    case steering_kinematics::BICYCLE_CONFIG:
      return has_positions ? odometry_.update_from_position(states[0], states[1], dt)
                           : odometry_.update_from_velocity(states[0], states[1], dt);
    case steering_kinematics::TRICYCLE_CONFIG:
      return has_positions ? odometry_.update_from_position(states[0], states[1], states[2], dt)
                           : odometry_.update_from_velocity(states[0], states[1], states[2], dt);
    default:
      return has_positions
                 ? odometry_.update_from_position(states[0], states[1], states[2], states[3], dt)
                 : odometry_.update_from_velocity(states[0], states[1], states[2], states[3], dt);
  }
}

void SteeringControllersLibrary::write_commands(double linear, double angular) {
  const size_t wheels = params_.traction_joints_names.size();
  std::vector<double> commands(wheels, 0.0);  // without a reference the wheels stop
  if (!std::isnan(linear) && !std::isnan(angular)) {
    const auto [traction, steering] = odometry_.get_commands(
        linear, angular, params_.open_loop, params_.reduce_wheel_speed_until_steering_reached);
    commands = traction;
    commands.insert(commands.end(), steering.begin(), steering.end());
  }
  for (size_t i = 0; i < commands.size(); ++i) {
    if (command_interfaces_[i].set_value(commands[i])) continue;
    RCLCPP_WARN(get_node()->get_logger(), "Unable to set %s command at index %zu: value = %f",
                i < wheels ? "traction" : "steering", i < wheels ? i : i - wheels, commands[i]);
    return;
  }
}

void SteeringControllersLibrary::publish_odometry(const rclcpp::Time& time) {
  tf2::Quaternion orientation;
  orientation.setRPY(0.0, 0.0, odometry_.get_heading());
  geometry_msgs::msg::Quaternion rotation;
  rotation.z = orientation.z();
  rotation.w = orientation.w();
  odometry_message_.header.stamp = time;
  odometry_message_.pose.pose.position.x = odometry_.get_x();
  odometry_message_.pose.pose.position.y = odometry_.get_y();
  odometry_message_.pose.pose.orientation = rotation;
  odometry_message_.twist.twist.linear.x = odometry_.get_linear();
  odometry_message_.twist.twist.angular.z = odometry_.get_angular();
  odometry_publisher_->try_publish(odometry_message_);
  if (!params_.enable_odom_tf) return;
  auto& transform = transform_message_.transforms.front();
  transform.header.stamp = time;
  transform.transform.translation.x = odometry_.get_x();
  transform.transform.translation.y = odometry_.get_y();
  transform.transform.rotation = rotation;
  transform_publisher_->try_publish(transform_message_);
}

void SteeringControllersLibrary::publish_status(const rclcpp::Time& time) {
  auto& status = status_message_;
  status.header.stamp = time;
  status.traction_wheels_position.clear();
  status.traction_wheels_velocity.clear();
  status.steer_positions.clear();
  status.linear_velocity_command.clear();
  status.steering_angle_command.clear();
  const size_t wheels = params_.traction_joints_names.size();
  auto& driven =
      params_.position_feedback ? status.traction_wheels_position : status.traction_wheels_velocity;
  for (size_t i = 0; i < command_interfaces_.size(); ++i) {
    const auto state = state_interfaces_[i].get_optional();
    const auto command = command_interfaces_[i].get_optional();
    if (!state || !command) continue;
    (i < wheels ? driven : status.steer_positions).push_back(*state);
    (i < wheels ? status.linear_velocity_command : status.steering_angle_command)
        .push_back(*command);
  }
  status_publisher_->try_publish(status);
}

}  // namespace steering_controllers_library
