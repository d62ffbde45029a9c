// A PID for each of several degrees of freedom, with references from a topic or a controller.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "control_msgs/msg/multi_dof_command.hpp"
#include "control_msgs/msg/multi_dof_state_stamped.hpp"
#include "control_toolbox/pid.hpp"
#include "controller_interface/chainable_controller_interface.hpp"
#include "pid_controller/pid_parameters.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_publisher.hpp"
#include "realtime_tools/realtime_thread_safe_box.hpp"
#include "std_srvs/srv/set_bool.hpp"

namespace pid_controller {

class PidController : public controller_interface::ChainableControllerInterface {
 public:
  using ControllerReferenceMsg = control_msgs::msg::MultiDOFCommand;
  using ControllerMeasuredStateMsg = control_msgs::msg::MultiDOFCommand;
  using ControllerModeSrvType = std_srvs::srv::SetBool;
  using ControllerStateMsg = control_msgs::msg::MultiDOFStateStamped;

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_cleanup(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::return_type update_reference_from_subscribers(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;
  controller_interface::return_type update_and_write_commands(
      const rclcpp::Time& time, const rclcpp::Duration& period) override;

 protected:
  std::vector<hardware_interface::CommandInterface::SharedPtr> on_export_reference_interfaces_list()
      override;
  std::vector<hardware_interface::StateInterface::SharedPtr> on_export_state_interfaces_list()
      override;
  bool on_set_chained_mode(bool chained_mode) override;

 private:
  bool configure_parameters();
  void create_topics();
  void set_gains();
  void on_reference(const ControllerReferenceMsg& message);
  void on_measured_state(const ControllerMeasuredStateMsg& message);
  void read_measured_state();
  void set_first_setpoint();
  /// NaN when there is none.
  double reference(size_t place) const;
  double error_of(size_t dof, double reference) const;
  /// NaN when there is nothing to command.
  double command_of(size_t dof, const rclcpp::Duration& period);
  void publish_state(const rclcpp::Time& time, const rclcpp::Duration& period);

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::vector<std::string> dofs_;  ///< of references and states
  bool has_derivative_ = false;
  std::vector<std::unique_ptr<control_toolbox::Pid>> pids_;
  std::atomic<bool> is_feedforward_enabled_ = false;

  realtime_tools::RealtimeThreadSafeBox<ControllerReferenceMsg> input_reference_;
  realtime_tools::RealtimeThreadSafeBox<ControllerMeasuredStateMsg> input_state_;
  std::vector<double> measured_;  ///< values, and then their derivatives

  rclcpp::Subscription<ControllerReferenceMsg>::SharedPtr reference_subscription_;
  rclcpp::Subscription<ControllerMeasuredStateMsg>::SharedPtr state_subscription_;
  rclcpp::Service<ControllerModeSrvType>::SharedPtr feedforward_service_;
  std::unique_ptr<realtime_tools::RealtimePublisher<ControllerStateMsg>> state_publisher_;
  ControllerStateMsg state_message_;
};

}  // namespace pid_controller
