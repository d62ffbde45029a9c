// The life of DiffDriveController: parameters, topics, interfaces.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>

#include "diff_drive_controller/diff_drive_controller.hpp"
#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace diff_drive_controller {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using hardware_interface::HW_IF_POSITION;
using hardware_interface::HW_IF_VELOCITY;

const char* DiffDriveController::feedback_type() const {
  return params_.position_feedback ? HW_IF_POSITION : HW_IF_VELOCITY;
}

CallbackReturn DiffDriveController::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration DiffDriveController::command_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const auto* side : {&params_.left_wheel_names, &params_.right_wheel_names}) {
    for (const std::string& wheel : *side) wanted.names.push_back(wheel + "/" + HW_IF_VELOCITY);
  }
  return wanted;
}

InterfaceConfiguration DiffDriveController::state_interface_configuration() const {
  if (params_.open_loop) return {interface_configuration_type::NONE, {}};
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const auto* side : {&params_.left_wheel_names, &params_.right_wheel_names}) {
    for (const std::string& wheel : *side) wanted.names.push_back(wheel + "/" + feedback_type());
  }
  return wanted;
}

CallbackReturn DiffDriveController::on_configure(const rclcpp_lifecycle::State&) {
  const auto logger = get_node()->get_logger();
  if (param_listener_->try_update_params(params_)) RCLCPP_INFO(logger, "Parameters were updated");
  if (params_.left_wheel_names.size() != params_.right_wheel_names.size()) {
    RCLCPP_ERROR(
        logger,
        "The number of left wheels [%zu] and the number of right wheels [%zu] are different",
        params_.left_wheel_names.size(), params_.right_wheel_names.size());
    return CallbackReturn::ERROR;
  }
  wheels_ = {params_.wheel_separation_multiplier * params_.wheel_separation,
             params_.left_wheel_radius_multiplier * params_.wheel_radius,
             params_.right_wheel_radius_multiplier * params_.wheel_radius};
  odometry_.setWheelParams(wheels_.separation, wheels_.left_radius, wheels_.right_radius);
  odometry_.setVelocityRollingWindowSize(
      static_cast<size_t>(std::max<int64_t>(1, params_.velocity_rolling_window_size)));
  cmd_vel_timeout_ = rclcpp::Duration::from_seconds(params_.cmd_vel_timeout);
  ignore_deprecated_limits(params_.linear.x);
  ignore_deprecated_limits(params_.angular.z);
  if (!create_limiter(limiter_linear_, params_.linear.x, "linear") ||
      !create_limiter(limiter_angular_, params_.angular.z, "angular")) {
    return CallbackReturn::ERROR;
  }
  if (!reset()) return CallbackReturn::ERROR;
  create_publishers();
  prepare_messages();
  velocity_command_subscriber_ = get_node()->create_subscription<TwistStamped>(
      "~/cmd_vel", rclcpp::SystemDefaultsQoS(),
      [this](const std::shared_ptr<TwistStamped> message) { on_command(message); });
  return CallbackReturn::SUCCESS;
}

void DiffDriveController::ignore_deprecated_limits(AxisLimits& limits) {
  const auto logger = get_node()->get_logger();
  if (!limits.has_velocity_limits) {
    RCLCPP_WARN(logger,
                "[deprecated] has_velocity_limits parameter is deprecated, instead set the "
                "respective limits to NAN");
    limits.min_velocity = limits.max_velocity = kNotANumber;
  }
  if (!limits.has_acceleration_limits) {
    RCLCPP_WARN(logger,
                "[deprecated] has_acceleration_limits parameter is deprecated, instead set the "
                "respective limits to NAN");
    limits.max_deceleration = limits.max_acceleration = kNotANumber;
    limits.max_deceleration_reverse = limits.max_acceleration_reverse = kNotANumber;
  }
  if (!limits.has_jerk_limits) {
    RCLCPP_WARN(logger,
                "[deprecated] has_jerk_limits parameter is deprecated, instead set the respective "
                "limits to NAN");
    limits.min_jerk = limits.max_jerk = kNotANumber;
  }
}

bool DiffDriveController::create_limiter(std::unique_ptr<SpeedLimiter>& limiter,
                                         const AxisLimits& limits, const char* axis) {
  try {
    limiter = std::make_unique<SpeedLimiter>(
        limits.min_velocity, limits.max_velocity, limits.max_acceleration_reverse,
        limits.max_acceleration, limits.max_deceleration, limits.max_deceleration_reverse,
        limits.min_jerk, limits.max_jerk);
    return true;
  } catch (const std::invalid_argument& error) {
    RCLCPP_ERROR(get_node()->get_logger(), "Failed to configure %s speed limiter: %s", axis,
                 error.what());
    return false;
  }
}

void DiffDriveController::create_publishers() {
  const auto node = get_node();
  const rclcpp::SystemDefaultsQoS qos;
  odometry_publisher_ =
      std::make_shared<realtime_tools::RealtimePublisher<nav_msgs::msg::Odometry>>(
          node->create_publisher<nav_msgs::msg::Odometry>("~/odom", qos));
  transform_publisher_ =
      std::make_shared<realtime_tools::RealtimePublisher<tf2_msgs::msg::TFMessage>>(
          node->create_publisher<tf2_msgs::msg::TFMessage>("/tf", qos));
  if (!params_.publish_limited_velocity) return;
  limited_velocity_publisher_ = std::make_shared<realtime_tools::RealtimePublisher<TwistStamped>>(
      node->create_publisher<TwistStamped>("~/cmd_vel_out", qos));
}

std::string DiffDriveController::frame_prefix() const {
  if (!params_.tf_frame_prefix_enable) return "";
  std::string prefix =
      params_.tf_frame_prefix.empty() ? get_node()->get_namespace() : params_.tf_frame_prefix;
  if (prefix.back() != '/') prefix += '/';
  if (prefix.front() == '/') prefix.erase(0, 1);
  return prefix;
}

void DiffDriveController::prepare_messages() {
  const std::string prefix = frame_prefix();
  odometry_message_ = nav_msgs::msg::Odometry();
  odometry_message_.header.frame_id = prefix + params_.odom_frame_id;
  odometry_message_.child_frame_id = prefix + params_.base_frame_id;
  for (size_t i = 0; i < 6; ++i) {
    odometry_message_.pose.covariance[7 * i] = params_.pose_covariance_diagonal[i];
    odometry_message_.twist.covariance[7 * i] = params_.twist_covariance_diagonal[i];
  }
  transform_message_.transforms.resize(1);
  transform_message_.transforms.front().header.frame_id = odometry_message_.header.frame_id;
  transform_message_.transforms.front().child_frame_id = odometry_message_.child_frame_id;
  publish_period_ = rclcpp::Duration::from_seconds(1.0 / params_.publish_rate);
  last_publication_.reset();
}

void DiffDriveController::on_command(const std::shared_ptr<TwistStamped>& message) {
  const auto logger = get_node()->get_logger();
  if (!subscriber_is_active_) {
    RCLCPP_WARN(logger, "Can't accept new commands. subscriber is inactive");
    return;
  }
  auto& stamp = message->header.stamp;
  if (stamp.sec == 0 && stamp.nanosec == 0) {
    RCLCPP_WARN_ONCE(logger,
                     "Received TwistStamped with zero timestamp, setting it to current "
                     "time, this message will only be shown once");
    stamp = get_node()->now();
  }
  const rclcpp::Duration age = get_node()->now() - stamp;
  if (cmd_vel_timeout_.nanoseconds() == 0 || age < cmd_vel_timeout_) {
    received_velocity_msg_.set(*message);
    return;
  }
  RCLCPP_WARN(logger,
              "Ignoring the received message (timestamp %.10f) because it is older than "
              "the current time by %.10f seconds, which exceeds the allowed timeout (%.4f)",
              rclcpp::Time(stamp).seconds(), age.seconds(), cmd_vel_timeout_.seconds());
}

CallbackReturn DiffDriveController::on_activate(const rclcpp_lifecycle::State&) {
  const auto left =
      configure_side("left", params_.left_wheel_names, registered_left_wheel_handles_);
  const auto right =
      configure_side("right", params_.right_wheel_names, registered_right_wheel_handles_);
  if (left == CallbackReturn::ERROR || right == CallbackReturn::ERROR) {
    return CallbackReturn::ERROR;
  }
  subscriber_is_active_ = true;
  RCLCPP_DEBUG(get_node()->get_logger(), "Subscriber and publisher are now active.");
  return CallbackReturn::SUCCESS;
}

CallbackReturn DiffDriveController::configure_side(const std::string& side,
                                                   const std::vector<std::string>& wheel_names,
                                                   std::vector<WheelHandle>& handles) {
  const auto logger = get_node()->get_logger();
  if (wheel_names.empty()) {
    RCLCPP_ERROR(logger, "No '%s' wheel names specified", side.c_str());
    return CallbackReturn::ERROR;
  }
  for (const std::string& wheel : wheel_names) {
    const auto command = std::find_if(
        command_interfaces_.begin(), command_interfaces_.end(), [&wheel](const auto& one) {
          return one.get_prefix_name() == wheel && one.get_interface_name() == HW_IF_VELOCITY;
        });
    if (command == command_interfaces_.end()) {
      RCLCPP_ERROR(logger, "Unable to obtain joint command handle for %s", wheel.c_str());
      return CallbackReturn::ERROR;
    }
    if (params_.open_loop) {
      handles.push_back({std::nullopt, std::ref(*command)});
      continue;
    }
    const auto state = std::find_if(
        state_interfaces_.cbegin(), state_interfaces_.cend(), [this, &wheel](const auto& one) {
          return one.get_prefix_name() == wheel && one.get_interface_name() == feedback_type();
        });
    if (state == state_interfaces_.cend()) {
      RCLCPP_ERROR(logger, "Unable to obtain joint state handle for %s", wheel.c_str());
      return CallbackReturn::ERROR;
    }
    handles.push_back({std::cref(*state), std::ref(*command)});
  }
  return CallbackReturn::SUCCESS;
}

CallbackReturn DiffDriveController::on_deactivate(const rclcpp_lifecycle::State&) {
  subscriber_is_active_ = false;
  halt();
  reset_buffers();
  registered_left_wheel_handles_.clear();
  registered_right_wheel_handles_.clear();
  return CallbackReturn::SUCCESS;
}

CallbackReturn DiffDriveController::on_cleanup(const rclcpp_lifecycle::State&) {
  return reset() ? CallbackReturn::SUCCESS : CallbackReturn::ERROR;
}

CallbackReturn DiffDriveController::on_error(const rclcpp_lifecycle::State&) {
  return reset() ? CallbackReturn::SUCCESS : CallbackReturn::ERROR;
}

bool DiffDriveController::reset() {
  odometry_.resetOdometry();
  reset_buffers();
  registered_left_wheel_handles_.clear();
  registered_right_wheel_handles_.clear();
  subscriber_is_active_ = false;
  velocity_command_subscriber_.reset();
  return true;
}

void DiffDriveController::reset_buffers() {
  for (const auto& reference : ordered_exported_reference_interfaces_) {
    if (!reference->set_value(kNotANumber)) {
      RCLCPP_WARN(get_node()->get_logger(), "Failed to reset reference interface to NaN");
    }
  }
  // Zeros, so that the first command is limited like any other.
  last_linear_ = last_angular_ = {0.0, 0.0};
  command_msg_ = TwistStamped();
  command_msg_.header.stamp = get_node()->now();
  command_msg_.twist.linear.x = command_msg_.twist.angular.z = kNotANumber;
  received_velocity_msg_.set(command_msg_);
}

void DiffDriveController::halt() {
  for (auto* wheels : {&registered_left_wheel_handles_, &registered_right_wheel_handles_}) {
    for (WheelHandle& wheel : *wheels) {
      if (!wheel.velocity.get().set_value(0.0)) {
        RCLCPP_WARN(get_node()->get_logger(), "Failed to set wheel velocity to value 0.0");
      }
    }
  }
}

bool DiffDriveController::on_set_chained_mode(bool) {
  return true;
}

std::vector<hardware_interface::CommandInterface::SharedPtr>
DiffDriveController::on_export_reference_interfaces_list() {
  std::vector<hardware_interface::CommandInterface::SharedPtr> references;
  for (const char* axis : {"/linear", "/angular"}) {
    references.push_back(std::make_shared<hardware_interface::CommandInterface>(
        get_node()->get_name() + std::string(axis), HW_IF_VELOCITY));
  }
  return references;
}

}  // namespace diff_drive_controller
