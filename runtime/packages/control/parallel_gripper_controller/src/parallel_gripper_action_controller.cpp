// See parallel_gripper_action_controller.hpp.
#include "parallel_gripper_action_controller/parallel_gripper_action_controller.hpp"

#include <chrono>
#include <cstdio>
#include <exception>

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace parallel_gripper_action_controller {
namespace {

using gripper_controllers::GripState;
using ros2wasm_parameters::gt_eq;
using ros2wasm_parameters::kReadOnly;

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("action_monitor_rate", params.action_monitor_rate, {"Hz", kReadOnly}, {gt_eq(0.1)});
  of.add("joint", params.joint, {"The joint of the gripper.", kReadOnly},
         {ros2wasm_parameters::not_empty<std::string>()});
  of.add("state_interfaces", params.state_interfaces, {"State interfaces of the joint."});
  of.add("goal_tolerance", params.limits.goal_tolerance, {"Greatest error at the goal."},
         {gt_eq(0.0)});
  of.add("allow_stalling", params.allow_stalling,
         {"Does a goal succeed when the gripper does not get on?"});
  of.add("stall_velocity_threshold", params.limits.stall_velocity_threshold,
         {"A slower gripper does not get on."});
  of.add("stall_timeout", params.limits.stall_timeout,
         {"Seconds after which such a gripper is stalled."}, {gt_eq(0.0)});
  of.add("max_effort_interface", params.max_effort_interface,
         {"Full name of the command interface of the greatest effort."});
  of.add("max_effort", params.max_effort, {"Greatest effort without one in the goal [N]."},
         {gt_eq(0.0)});
  of.add("max_velocity_interface", params.max_velocity_interface,
         {"Full name of the command interface of the greatest speed."});
  of.add("max_velocity", params.max_velocity, {"Greatest speed without one in the goal [m/s]."},
         {gt_eq(0.0)});
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

CallbackReturn GripperActionController::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration GripperActionController::command_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL,
                                {params_.joint + "/position"}};
  for (const std::string& more : {params_.max_effort_interface, params_.max_velocity_interface}) {
    if (!more.empty()) wanted.names.push_back(more);
  }
  return wanted;
}

InterfaceConfiguration GripperActionController::state_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& name : params_.state_interfaces) {
    wanted.names.push_back(params_.joint + "/" + name);
  }
  return wanted;
}

CallbackReturn GripperActionController::on_configure(const rclcpp_lifecycle::State&) {
  const auto logger = get_node()->get_logger();
  params_ = param_listener_->get_params();
  RCLCPP_INFO(logger, "Action status changes will be monitored at %f Hz.",
              params_.action_monitor_rate);
  if (params_.joint.empty()) {
    RCLCPP_ERROR(logger, "Joint name cannot be empty");
    return CallbackReturn::ERROR;
  }
  RCLCPP_INFO(logger, "Joint name is : %s", params_.joint.c_str());
  return CallbackReturn::SUCCESS;
}

bool GripperActionController::find_interfaces() {
  const auto find = [](auto& interfaces, const std::string& name, auto& found) {
    found.reset();
    for (auto& one : interfaces) {
      if (!name.empty() && one.get_name() == name) found = std::ref(one);
    }
    return name.empty() || found.has_value();
  };
  const auto logger = get_node()->get_logger();
  if (!find(command_interfaces_, params_.joint + "/position", position_command_)) {
    RCLCPP_ERROR(logger, "Expected 1 %s command interface", "position");
    return false;
  }
  if (!find(state_interfaces_, params_.joint + "/position", position_)) {
    RCLCPP_ERROR(logger, "Expected 1 position state interface");
    return false;
  }
  if (!find(state_interfaces_, params_.joint + "/velocity", velocity_)) {
    RCLCPP_ERROR(logger, "Expected 1 velocity state interface");
    return false;
  }
  if (!find(command_interfaces_, params_.max_effort_interface, effort_command_)) {
    RCLCPP_ERROR(logger, "Expected max effort command interface `%s` not found",
                 params_.max_effort_interface.c_str());
    return false;
  }
  if (!find(command_interfaces_, params_.max_velocity_interface, velocity_command_)) {
    RCLCPP_ERROR(logger, "Expected max velocity command interface `%s` not found",
                 params_.max_velocity_interface.c_str());
    return false;
  }
  return true;
}

CallbackReturn GripperActionController::on_activate(const rclcpp_lifecycle::State&) {
  if (!find_interfaces()) return CallbackReturn::ERROR;
  wanted_position_ = position_->get().get_optional().value_or(0.0);
  use_limits_of_parameters();
  create_action();
  return CallbackReturn::SUCCESS;
}

void GripperActionController::use_limits_of_parameters() {
  wanted_velocity_ = params_.max_velocity;
  wanted_effort_ = params_.max_effort;
}

void GripperActionController::create_action() {
  action_server_ = rclcpp_action::create_server<GripperCommandAction>(
      get_node(), "~/gripper_cmd",
      [this](const rclcpp_action::GoalUUID&,
             std::shared_ptr<const GripperCommandAction::Goal> goal) {
        const auto logger = get_node()->get_logger();
        const size_t values = goal->command.position.size();
        if (values == 1) {
          RCLCPP_INFO(logger, "Received & accepted new action goal");
          return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
        }
        RCLCPP_ERROR(
            logger, "Received action goal with wrong number of position values, expects 1, got %zu",
            values);
        return rclcpp_action::GoalResponse::REJECT;
      },
      [this](const std::shared_ptr<GoalHandle> handle) { return on_cancel(handle); },
      [this](const std::shared_ptr<GoalHandle> handle) { on_accepted(handle); });
}

CallbackReturn GripperActionController::on_deactivate(const rclcpp_lifecycle::State&) {
  const std::lock_guard<std::mutex> lock(mutex_);
  position_command_.reset();
  velocity_command_.reset();
  effort_command_.reset();
  position_.reset();
  velocity_.reset();
  return CallbackReturn::SUCCESS;
}

rclcpp_action::CancelResponse GripperActionController::on_cancel(
    const std::shared_ptr<GoalHandle>& handle) {
  const auto logger = get_node()->get_logger();
  RCLCPP_INFO(logger, "Got request to cancel goal");
  const std::lock_guard<std::mutex> lock(mutex_);
  if (goal_ && goal_->gh_ == handle) {
    if (position_) wanted_position_ = position_->get().get_optional().value_or(wanted_position_);
    use_limits_of_parameters();
    RCLCPP_INFO(logger, "Canceling active action goal because cancel callback received.");
    goal_->setCanceled(std::make_shared<GripperCommandAction::Result>());
    goal_.reset();
  }
  return rclcpp_action::CancelResponse::ACCEPT;
}

void GripperActionController::on_accepted(const std::shared_ptr<GoalHandle>& handle) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (goal_) goal_->setAborted(std::make_shared<GripperCommandAction::Result>());
  // Also for one that has just ended: its timer goes.
  if (watched_goal_) watched_goal_->runNonRealtime();
  const auto& command = handle->get_goal()->command;
  use_limits_of_parameters();
  wanted_position_ = command.position[0];
  if (velocity_command_ && !command.velocity.empty()) wanted_velocity_ = command.velocity[0];
  if (effort_command_ && !command.effort.empty()) wanted_effort_ = command.effort[0];
  grip_.start(get_node()->now().nanoseconds());
  goal_ = std::make_shared<RealtimeGoal>(handle);
  goal_->execute();
  watched_goal_ = goal_;
  const auto period = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(1.0 / params_.action_monitor_rate));
  goal_timer_ = get_node()->create_wall_timer(period, [this, goal = goal_] {
    goal->runNonRealtime();
    if (!goal->gh_->is_active()) goal_timer_->cancel();
  });
}

void GripperActionController::check_goal(double position, double velocity) {
  if (!goal_) return;
  const GripState state = grip_.look(get_node()->now().nanoseconds(), wanted_position_ - position,
                                     velocity, params_.limits);
  if (state == GripState::kMoving) return;
  auto result = std::make_shared<GripperCommandAction::Result>();
  result->state.position = {position};
  result->state.effort = {0.0};
  result->reached_goal = state == GripState::kReached;
  result->stalled = state == GripState::kStalled;
  if (result->reached_goal || params_.allow_stalling) {
    goal_->setSucceeded(result);
  } else {
    goal_->setAborted(result);
  }
  goal_.reset();
}

void GripperActionController::write(Command& interface, const char* what, double value) {
  if (interface && !interface->get().set_value(value)) {
    RCLCPP_WARN(get_node()->get_logger(), "Unable to set the %s command to: %f", what, value);
  }
}

return_type GripperActionController::update(const rclcpp::Time&, const rclcpp::Duration&) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!position_ || !velocity_) return return_type::OK;
  const auto position = position_->get().get_optional();
  const auto velocity = velocity_->get().get_optional();
  if (!position || !velocity) return return_type::OK;
  check_goal(*position, *velocity);
  write(position_command_, "joint position", wanted_position_);
  write(velocity_command_, "speed", wanted_velocity_);
  write(effort_command_, "effort", wanted_effort_);
  return return_type::OK;
}

}  // namespace parallel_gripper_action_controller

PLUGINLIB_EXPORT_CLASS(parallel_gripper_action_controller::GripperActionController,
                       controller_interface::ControllerInterface)
