// Opens and closes a parallel gripper by an action, with limits of its speed and effort.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "control_msgs/action/parallel_gripper_command.hpp"
#include "controller_interface/controller_interface.hpp"
#include "gripper_controllers/grip.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_server_goal_handle.hpp"
#include "ros2wasm_parameters/parameters.hpp"

namespace parallel_gripper_action_controller {

struct Params {
  double action_monitor_rate = 20.0;
  std::string joint;
  std::vector<std::string> state_interfaces = {"position", "velocity"};
  gripper_controllers::GripLimits limits;
  bool allow_stalling = false;
  std::string max_effort_interface;
  double max_effort = 10.0;
  std::string max_velocity_interface;
  double max_velocity = 0.1;
};

class GripperActionController : public controller_interface::ControllerInterface {
 public:
  using GripperCommandAction = control_msgs::action::ParallelGripperCommand;

  controller_interface::InterfaceConfiguration command_interface_configuration() const override;
  controller_interface::InterfaceConfiguration state_interface_configuration() const override;
  controller_interface::return_type update(const rclcpp::Time& time,
                                           const rclcpp::Duration& period) override;
  controller_interface::CallbackReturn on_init() override;
  controller_interface::CallbackReturn on_configure(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_activate(
      const rclcpp_lifecycle::State& previous_state) override;
  controller_interface::CallbackReturn on_deactivate(
      const rclcpp_lifecycle::State& previous_state) override;

 private:
  using GoalHandle = rclcpp_action::ServerGoalHandle<GripperCommandAction>;
  using RealtimeGoal = realtime_tools::RealtimeServerGoalHandle<GripperCommandAction>;
  using ParamListener = ros2wasm_parameters::ParameterListener<Params>;
  using Command = std::optional<std::reference_wrapper<hardware_interface::LoanedCommandInterface>>;
  using State = std::optional<std::reference_wrapper<hardware_interface::LoanedStateInterface>>;

  bool find_interfaces();
  void create_action();
  void use_limits_of_parameters();
  rclcpp_action::CancelResponse on_cancel(const std::shared_ptr<GoalHandle>& handle);
  void on_accepted(const std::shared_ptr<GoalHandle>& handle);
  void check_goal(double position, double velocity);
  void write(Command& interface, const char* what, double value);

  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  Command position_command_;
  Command velocity_command_;
  Command effort_command_;
  State position_;
  State velocity_;

  std::mutex mutex_;  ///< between the control loop and the action
  double wanted_position_ = 0.0;
  double wanted_velocity_ = 0.0;
  double wanted_effort_ = 0.0;
  gripper_controllers::Grip grip_;
  std::shared_ptr<RealtimeGoal> goal_;
  std::shared_ptr<RealtimeGoal> watched_goal_;  ///< the last one, until its client knows the end
  rclcpp_action::Server<GripperCommandAction>::SharedPtr action_server_;
  rclcpp::TimerBase::SharedPtr goal_timer_;
};

}  // namespace parallel_gripper_action_controller
