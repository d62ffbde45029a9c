// Drives a base with two driven sides by ~/cmd_vel or by references, and publishes where it is.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller_interface/chainable_controller_interface.hpp"
#include "diff_drive_controller/diff_drive_parameters.hpp"
#include "diff_drive_controller/odometry.hpp"
#include "diff_drive_controller/speed_limiter.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "realtime_tools/realtime_thread_safe_box.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

namespace diff_drive_controller {

class DiffDriveController : public controller_interface::ChainableControllerInterface {
  using TwistStamped = geometry_msgs::msg::TwistStamped;

 public:
  DiffDriveController() = default;

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::return_type update_reference_from_subscribers(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;
  controller_interface::return_type update_and_write_commands(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_cleanup(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_error(
      const rclcpp_lifecycle::State& previous_state) override;

 protected:
  struct WheelHandle {
    std::optional<std::reference_wrapper<const hardware_interface::LoanedStateInterface>> feedback;
    std::reference_wrapper<hardware_interface::LoanedCommandInterface> velocity;
  };
  enum class Feedback { kRead, kBusy, kInvalid };

  bool on_set_chained_mode(bool chained_mode) override;
  std::vector<hardware_interface::CommandInterface::SharedPtr> on_export_reference_interfaces_list()
      override;

  const char* feedback_type() const;
  controller_interface::CallbackReturn configure_side(const std::string& side,
                                                      const std::vector<std::string>& wheel_names,
                                                      std::vector<WheelHandle>& handles);
  bool reset();
  void halt();

  std::vector<WheelHandle> registered_left_wheel_handles_;
  std::vector<WheelHandle> registered_right_wheel_handles_;
  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  WheelGeometry wheels_;
  Odometry odometry_;
  rclcpp::Duration cmd_vel_timeout_ = rclcpp::Duration::from_seconds(0.5);

 private:
  void ignore_deprecated_limits(AxisLimits& limits);
  bool create_limiter(std::unique_ptr<SpeedLimiter>& limiter, const AxisLimits& limits,
                      const char* axis);
  std::string frame_prefix() const;
  void prepare_messages();
  void create_publishers();
  void on_command(const std::shared_ptr<TwistStamped>& message);
  void reset_buffers();
  Feedback read_side(const std::vector<WheelHandle>& wheels, double& mean) const;
  /// False when the feedback is missing.
  bool update_odometry(double linear, double angular, const rclcpp::Time& time, double period_s,
                       controller_interface::return_type& result);
  bool is_time_to_publish(const rclcpp::Time& time);
  void publish_odometry(const rclcpp::Time& time);
  void command_wheels(double linear, double angular);

  template <class MessageT>
  using Publisher = std::shared_ptr<realtime_tools::RealtimePublisher<MessageT>>;
  Publisher<nav_msgs::msg::Odometry> odometry_publisher_;
  nav_msgs::msg::Odometry odometry_message_;
  Publisher<tf2_msgs::msg::TFMessage> transform_publisher_;
  tf2_msgs::msg::TFMessage transform_message_;
  Publisher<TwistStamped> limited_velocity_publisher_;
  TwistStamped limited_velocity_message_;

  bool subscriber_is_active_ = false;
  rclcpp::Subscription<TwistStamped>::SharedPtr velocity_command_subscriber_;
  realtime_tools::RealtimeThreadSafeBox<TwistStamped> received_velocity_msg_;
  TwistStamped command_msg_;  ///< the last one; NaN until one has come

  std::array<double, 2> last_linear_{};   ///< the last command after the limits, and that before
  std::array<double, 2> last_angular_{};  ///< the same
  std::unique_ptr<SpeedLimiter> limiter_linear_;
  std::unique_ptr<SpeedLimiter> limiter_angular_;

  rclcpp::Duration publish_period_ = rclcpp::Duration::from_nanoseconds(0);
  std::optional<rclcpp::Time> last_update_;  ///< of the reference, out of chained mode
  std::optional<rclcpp::Time> last_publication_;
};

}  // namespace diff_drive_controller
