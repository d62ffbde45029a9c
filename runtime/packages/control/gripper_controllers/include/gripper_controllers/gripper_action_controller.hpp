// Opens and closes a gripper by an action, through its position or its effort.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "control_msgs/action/gripper_command.hpp"
#include "control_toolbox/pid.hpp"
#include "controller_interface/controller_interface.hpp"
#include "gripper_controllers/grip.hpp"
#include "rclcpp_action/rclcpp_action.hpp"
#include "rclcpp_lifecycle/state.hpp"
#include "realtime_tools/realtime_server_goal_handle.hpp"
#include "ros2wasm_parameters/parameters.hpp"

namespace gripper_action_controller {

struct Params {
  double action_monitor_rate = 20.0;
  std::string joint;
  gripper_controllers::GripLimits limits;
  double max_effort = 0.0;
  bool allow_stalling = false;
};

class GripperActionController : public controller_interface::ControllerInterface {
 public:
  using GripperCommandAction = control_msgs::action::GripperCommand;

  /// `interface`: position or effort.
  explicit GripperActionController(const char* interface) : interface_(interface) {}

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

  bool is_by_effort() const;
  template <class InterfacesT>
  auto find(InterfacesT& interfaces, const char* name, const char* expected, const char* differs);
  void read_gains();
  void create_action();
  rclcpp_action::CancelResponse on_cancel(const std::shared_ptr<GoalHandle>& handle);
  void on_accepted(const std::shared_ptr<GoalHandle>& handle);
  void check_goal(const rclcpp::Time& time, double position, double velocity);
  void command(double position, double velocity, const rclcpp::Duration& period);

  const char* interface_;
  std::shared_ptr<ParamListener> param_listener_;
  Params params_;
  std::optional<std::reference_wrapper<hardware_interface::LoanedCommandInterface>> command_;
  std::optional<std::reference_wrapper<hardware_interface::LoanedStateInterface>> position_;
  std::optional<std::reference_wrapper<hardware_interface::LoanedStateInterface>> velocity_;

  std::mutex mutex_;  ///< between the control loop and the action
  double wanted_position_ = 0.0;
  double max_effort_ = 0.0;
  double computed_command_ = 0.0;
  control_toolbox::Pid pid_;
  gripper_controllers::Grip grip_;
  std::shared_ptr<RealtimeGoal> goal_;
  std::shared_ptr<RealtimeGoal> watched_goal_;  ///< the last one, until its client knows the end
  rclcpp_action::Server<GripperCommandAction>::SharedPtr action_server_;
  rclcpp::TimerBase::SharedPtr goal_timer_;
};

}  // namespace gripper_action_controller

namespace position_controllers {

class GripperActionController : public gripper_action_controller::GripperActionController {
 public:
  GripperActionController() : gripper_action_controller::GripperActionController("position") {}
};

}  // namespace position_controllers

namespace effort_controllers {

class GripperActionController : public gripper_action_controller::GripperActionController {
 public:
  GripperActionController() : gripper_action_controller::GripperActionController("effort") {}
};

}  // namespace effort_controllers
