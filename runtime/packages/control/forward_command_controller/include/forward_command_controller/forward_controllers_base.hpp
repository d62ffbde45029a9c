// The base of controllers that pass on ~/commands as they come.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller_interface/controller_interface.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_thread_safe_box.hpp"
#include "std_msgs/msg/float64_multi_array.hpp"

namespace forward_command_controller {

using CmdType = std_msgs::msg::Float64MultiArray;

class ForwardControllersBase : public controller_interface::ControllerInterface {
 public:
  ForwardControllersBase() = default;
  ~ForwardControllersBase() override = default;

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::return_type update(const rclcpp::Time& time,
                                           const rclcpp::Duration& period) override;

 protected:
  /// May throw: on_init() reports it.
  virtual void declare_parameters() = 0;
  /// Sets command_interface_types_; called by on_configure().
  virtual controller_interface::CallbackReturn read_parameters() = 0;

  std::vector<std::string> joint_names_;
  std::string interface_name_;
  std::vector<std::string> command_interface_types_;  ///< full names, in the order of commands
  realtime_tools::RealtimeThreadSafeBox<CmdType> rt_command_;
  CmdType joint_commands_;  ///< the last one; NaN until one has come
  rclcpp::Subscription<CmdType>::SharedPtr joints_command_subscriber_;

 private:
  void forget_commands();
};

}  // namespace forward_command_controller
