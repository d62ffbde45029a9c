// The base of controllers of steered bases: references in, wheels and odometry out.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "control_msgs/msg/steering_controller_status.hpp"
#include "controller_interface/chainable_controller_interface.hpp"
#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "realtime_tools/realtime_thread_safe_box.hpp"
#include "steering_controllers_library/steering_kinematics.hpp"
#include "steering_controllers_library/steering_parameters.hpp"
#include "tf2_msgs/msg/tf_message.hpp"

namespace steering_controllers_library {

class SteeringControllersLibrary : public controller_interface::ChainableControllerInterface {
 public:
  using ControllerTwistReferenceMsg = geometry_msgs::msg::TwistStamped;
  using ControllerStateMsgOdom = nav_msgs::msg::Odometry;
  using ControllerStateMsgTf = tf2_msgs::msg::TFMessage;
  using SteeringControllerStateMsg = control_msgs::msg::SteeringControllerStatus;

  /// Declares the parameters of the derived class; may throw.
  virtual void initialize_implementation_parameter_listener() = 0;
  /// Sets the type and the wheels of odometry_.
  virtual controller_interface::CallbackReturn configure_odometry() = 0;
  /// By the references or the states of the wheels.
  virtual bool update_odometry(const rclcpp::Duration& period);

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::return_type update_reference_from_subscribers(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;
  controller_interface::return_type update_and_write_commands(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;

 protected:
  std::vector<hardware_interface::CommandInterface::SharedPtr> on_export_reference_interfaces_list()
      override;
  bool on_set_chained_mode(bool chained_mode) override;

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  steering_kinematics::SteeringKinematics odometry_;
  double last_linear_velocity_ = 0.0;
  double last_angular_velocity_ = 0.0;

 private:
  template <class MessageT>
  using Publisher = std::unique_ptr<realtime_tools::RealtimePublisher<MessageT>>;

  void take_deprecated_names();
  bool check_joints();
  void create_topics();
  void prepare_messages();
  void on_reference(const std::shared_ptr<ControllerTwistReferenceMsg>& message);
  void forget_reference();
  void set_references(double linear, double angular);
  void write_commands(double linear, double angular);
  void publish_odometry(const rclcpp::Time& time);
  void publish_status(const rclcpp::Time& time);

  std::vector<std::string> traction_states_;  ///< joints with the states of the driven wheels
  std::vector<std::string> steering_states_;
  rclcpp::Duration ref_timeout_ = rclcpp::Duration::from_seconds(0.0);
  rclcpp::Subscription<ControllerTwistReferenceMsg>::SharedPtr reference_subscription_;
  realtime_tools::RealtimeThreadSafeBox<ControllerTwistReferenceMsg> input_ref_;
  ControllerTwistReferenceMsg current_ref_;
  std::optional<rclcpp::Time> last_time_;  ///< of update_reference_from_subscribers()
  Publisher<ControllerStateMsgOdom> odometry_publisher_;
  ControllerStateMsgOdom odometry_message_;
  Publisher<ControllerStateMsgTf> transform_publisher_;
  ControllerStateMsgTf transform_message_;
  Publisher<SteeringControllerStateMsg> status_publisher_;
  SteeringControllerStateMsg status_message_;
};

}  // namespace steering_controllers_library
