// See gripper_action_controller.hpp.
#include "gripper_controllers/gripper_action_controller.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>

#include "pluginlib/class_list_macros.hpp"
#include "rclcpp/logging.hpp"

namespace gripper_action_controller {
namespace {

using gripper_controllers::GripState;
using ros2wasm_parameters::gt_eq;

void describe(ros2wasm_parameters::Declarations& of, Params& params) {
  of.add("action_monitor_rate", params.action_monitor_rate,
         {"Rate at which feedback of the action is published [Hz]."}, {gt_eq(0.1)});
  of.add("joint", params.joint, {"The joint of the gripper."});
  of.add("goal_tolerance", params.limits.goal_tolerance, {"Greatest error at the goal."},
         {gt_eq(0.0)});
  of.add("max_effort", params.max_effort, {"Greatest effort without a goal."}, {gt_eq(0.0)});
  of.add("allow_stalling", params.allow_stalling,
         {"Does a goal succeed when the gripper does not get on?"});
  of.add("stall_velocity_threshold", params.limits.stall_velocity_threshold,
         {"A slower gripper does not get on."});
  of.add("stall_timeout", params.limits.stall_timeout,
         {"Seconds after which such a gripper is stalled."});
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

bool GripperActionController::is_by_effort() const {
  return std::string(interface_) == "effort";
}

CallbackReturn GripperActionController::on_init() {
  RCLCPP_WARN(get_node()->get_logger(),
              "[Deprecated]: the `position_controllers/GripperActionController` and "
              "`effort_controllers::GripperActionController` controllers are replaced by "
              "'parallel_gripper_controllers/GripperActionController' controller");
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
  return {interface_configuration_type::INDIVIDUAL, {params_.joint + "/" + interface_}};
}

InterfaceConfiguration GripperActionController::state_interface_configuration() const {
  return {interface_configuration_type::INDIVIDUAL,
          {params_.joint + "/position", params_.joint + "/velocity"}};
}

CallbackReturn GripperActionController::on_configure(const rclcpp_lifecycle::State&) {
  const auto logger = get_node()->get_logger();
  params_ = param_listener_->get_params();
  RCLCPP_INFO(logger, "Action status changes will be monitored at %f Hz.",
              params_.action_monitor_rate);
  if (!params_.joint.empty()) return CallbackReturn::SUCCESS;
  RCLCPP_ERROR(logger, "Joint name cannot be empty");
  return CallbackReturn::ERROR;
}

template <class InterfacesT>
auto GripperActionController::find(InterfacesT& interfaces, const char* name, const char* expected,
                                   const char* differs) {
  using Found = std::optional<std::reference_wrapper<typename InterfacesT::value_type>>;
  const auto logger = get_node()->get_logger();
  for (auto& one : interfaces) {
    if (one.get_interface_name() != name) continue;
    if (one.get_prefix_name() == params_.joint) return Found(std::ref(one));
    RCLCPP_ERROR(logger, "%s interface is different than joint name `%s` != `%s`", differs,
                 one.get_prefix_name().c_str(), params_.joint.c_str());
    return Found();
  }
  RCLCPP_ERROR(logger, "Expected 1 %s %s interface", name, expected);
  return Found();
}

CallbackReturn GripperActionController::on_activate(const rclcpp_lifecycle::State&) {
  command_ = find(command_interfaces_, interface_, "command", "Command");
  position_ = find(state_interfaces_, "position", "state", "Position state");
  velocity_ = find(state_interfaces_, "velocity", "state", "Velocity command");
  if (!command_ || !position_ || !velocity_) return CallbackReturn::ERROR;
  if (is_by_effort()) read_gains();
  wanted_position_ = position_->get().get_optional().value_or(0.0);
  max_effort_ = params_.max_effort;
  create_action();
  return CallbackReturn::SUCCESS;
}

void GripperActionController::read_gains() {
  const std::string at = "gains." + params_.joint + ".";
  const double p = auto_declare<double>(at + "p", 0.0);
  const double i = auto_declare<double>(at + "i", 0.0);
  const double d = auto_declare<double>(at + "d", 0.0);
  const double i_clamp = auto_declare<double>(at + "i_clamp", 0.0);
  pid_.initialize(p, i, d, i_clamp, -i_clamp);
}

void GripperActionController::create_action() {
  action_server_ = rclcpp_action::create_server<GripperCommandAction>(
      get_node(), "~/gripper_cmd",
      [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const GripperCommandAction::Goal>) {
        RCLCPP_INFO(get_node()->get_logger(), "Received & accepted new action goal");
        return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
      },
      [this](const std::shared_ptr<GoalHandle> handle) { return on_cancel(handle); },
      [this](const std::shared_ptr<GoalHandle> handle) { on_accepted(handle); });
}

CallbackReturn GripperActionController::on_deactivate(const rclcpp_lifecycle::State&) {
  const std::lock_guard<std::mutex> lock(mutex_);
  command_.reset();
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
    max_effort_ = params_.max_effort;
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
  wanted_position_ = handle->get_goal()->command.position;
  max_effort_ = handle->get_goal()->command.max_effort;
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

return_type GripperActionController::update(const rclcpp::Time&, const rclcpp::Duration& period) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!command_) return return_type::OK;
  const auto position = position_->get().get_optional();
  const auto velocity = velocity_->get().get_optional();
  if (!position || !velocity) return return_type::OK;
  check_goal(get_node()->now(), *position, *velocity);
  command(*position, *velocity, period);
  return return_type::OK;
}

void GripperActionController::check_goal(const rclcpp::Time& time, double position,
                                         double velocity) {
  if (!goal_) return;
  const GripState state =
      grip_.look(time.nanoseconds(), wanted_position_ - position, velocity, params_.limits);
  if (state == GripState::kMoving) return;
  auto result = std::make_shared<GripperCommandAction::Result>();
  result->effort = computed_command_;
  result->position = position;
  result->reached_goal = state == GripState::kReached;
  result->stalled = state == GripState::kStalled;
  if (result->reached_goal || params_.allow_stalling) {
    goal_->setSucceeded(result);
  } else {
    goal_->setAborted(result);
  }
  goal_.reset();
}

void GripperActionController::command(double position, double velocity,
                                      const rclcpp::Duration& period) {
  double value = wanted_position_;
  computed_command_ = max_effort_;
  if (is_by_effort()) {
    const double most = std::abs(max_effort_);
    value = pid_.compute_command(wanted_position_ - position, -velocity, period);
    value = computed_command_ = std::clamp(value, -most, most);
  }
  if (!command_->get().set_value(value)) {
    RCLCPP_DEBUG(get_node()->get_logger(), "Unable to set the command of the gripper");
  }
}

}  // namespace gripper_action_controller

PLUGINLIB_EXPORT_CLASS(position_controllers::GripperActionController,
                       controller_interface::ControllerInterface)
PLUGINLIB_EXPORT_CLASS(effort_controllers::GripperActionController,
                       controller_interface::ControllerInterface)
