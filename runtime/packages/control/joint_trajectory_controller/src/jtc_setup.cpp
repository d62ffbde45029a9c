// The life of JointTrajectoryController: parameters, interfaces, topics, services.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <numeric>

#include "joint_trajectory_controller/joint_trajectory_controller.hpp"
#include "rclcpp/qos.hpp"
#include "urdf/model.h"

namespace joint_trajectory_controller {
namespace {

bool has(const std::vector<std::string>& names, const char* name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Kinds kinds_of(const std::vector<std::string>& names) {
  return {has(names, "position"), has(names, "velocity"), has(names, "acceleration"),
          has(names, "effort")};
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

}  // namespace

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;

CallbackReturn JointTrajectoryController::on_init() {
  try {
    param_listener_ = std::make_shared<ParamListener>(get_node(), describe);
    params_ = param_listener_->get_params();
    read_model();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

void JointTrajectoryController::read_model() {
  wraps_.assign(params_.joints.size(), false);
  std::vector<double> max_velocities(params_.joints.size(), 0.0);
  const std::string& description = get_robot_description();
  if (!description.empty()) {
    urdf::Model model;
    if (!model.initString(description)) {
      throw std::runtime_error("Failed to parse robot description!");
    }
    for (size_t i = 0; i < params_.joints.size(); ++i) {
      const auto joint = model.getJoint(params_.joints[i]);
      if (!joint) continue;
      if (joint->limits) max_velocities[i] = joint->limits->velocity;
      wraps_[i] = joint->type == urdf::Joint::CONTINUOUS;
    }
  }
  check_deceleration(max_velocities);
}

void JointTrajectoryController::check_deceleration(const std::vector<double>& max_velocities) {
  const auto logger = get_node()->get_logger();
  brakes_on_cancel_ = params_.constraints.decelerate_on_cancel;
  max_deceleration_.clear();
  for (size_t i = 0; i < params_.joints.size() && brakes_on_cancel_; ++i) {
    const std::string& joint = params_.joints[i];
    const double deceleration = params_.constraints.joints.at(joint).max_deceleration_on_cancel;
    max_deceleration_.push_back(deceleration);
    if (deceleration <= 0.0) {
      RCLCPP_ERROR(logger,
                   "Joint [%s] invalid max_deceleration_on_cancel [%.1f]. "
                   "Falling back to hold position on cancel.",
                   joint.c_str(), deceleration);
      brakes_on_cancel_ = false;
    }
    if (max_velocities[i] <= 0.0) {
      RCLCPP_ERROR(logger,
                   "Joint [%s] has invalid joint velocity defined in URDF [%.1f]. "
                   "Falling back to hold position on cancel.",
                   joint.c_str(), max_velocities[i]);
      brakes_on_cancel_ = false;
    }
  }
}

InterfaceConfiguration JointTrajectoryController::command_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& joint : command_joints_) {
    for (const std::string& kind : params_.command_interfaces) {
      wanted.names.push_back(joint + "/" + kind);
    }
  }
  const std::string& scaling = params_.speed_scaling.command_interface;
  if (!scaling.empty()) wanted.names.push_back(scaling);
  return wanted;
}

InterfaceConfiguration JointTrajectoryController::state_interface_configuration() const {
  InterfaceConfiguration wanted{interface_configuration_type::INDIVIDUAL, {}};
  for (const std::string& joint : params_.joints) {
    for (const std::string& kind : params_.state_interfaces) {
      wanted.names.push_back(joint + "/" + kind);
    }
  }
  const std::string& scaling = params_.speed_scaling.state_interface;
  if (!scaling.empty()) wanted.names.push_back(scaling);
  return wanted;
}

CallbackReturn JointTrajectoryController::on_configure(const rclcpp_lifecycle::State&) {
  if (params_.open_loop_control) {
    RCLCPP_WARN(get_node()->get_logger(),
                "[deprecated] 'open_loop_control' parameter is deprecated. Instead, set the "
                "feedback gains to zero and use 'interpolate_from_desired_state' parameter");
  }
  param_listener_->refresh_dynamic_parameters();
  params_ = param_listener_->get_params();
  reset();
  if (!choose_joints() || !choose_interfaces()) return CallbackReturn::FAILURE;
  log_interfaces();
  default_tolerances_ = active_tolerances_ = tolerances_of_parameters();
  interpolation_ =
      params_.interpolation_method == "none" ? Interpolation::kNone : Interpolation::kSplines;
  RCLCPP_INFO(get_node()->get_logger(), "Using '%s' interpolation method.",
              params_.interpolation_method.c_str());
  create_topics();
  create_services();
  set_up_scaling();
  if (get_update_rate() == 0) {
    throw std::runtime_error("Controller's update rate is set to 0. This should not happen!");
  }
  update_period_ = rclcpp::Duration::from_nanoseconds(1'000'000'000 / get_update_rate());
  return CallbackReturn::SUCCESS;
}

bool JointTrajectoryController::choose_joints() {
  const auto logger = get_node()->get_logger();
  command_joints_ = params_.command_joints;
  if (command_joints_.empty()) {
    command_joints_ = params_.joints;
    RCLCPP_INFO(logger,
                "No specific joint names are used for command interfaces. Using 'joints' "
                "parameter.");
  }
  if (command_joints_.size() > params_.joints.size()) {
    RCLCPP_ERROR(
        logger,
        "The 'command_joints' parameter must not exceed the size of the 'joints' parameter.");
    return false;
  }
  if (command_joints_.size() == params_.joints.size()) {
    // They may have other names, e.g. those of a controller in between.
    command_places_.resize(command_joints_.size());
    std::iota(command_places_.begin(), command_places_.end(), 0);
    return true;
  }
  command_places_ = mapping(command_joints_, params_.joints);
  if (command_places_.size() == command_joints_.size()) return true;
  RCLCPP_ERROR(logger,
               "'command_joints' parameter must be a subset of 'joints' parameter, if their size "
               "is not equal.");
  return false;
}

bool JointTrajectoryController::choose_interfaces() {
  const auto logger = get_node()->get_logger();
  commands_ = kinds_of(params_.command_interfaces);
  states_ = kinds_of(params_.state_interfaces);
  const bool is_single = params_.command_interfaces.size() == 1;
  uses_pids_ =
      is_single && (commands_.effort || (commands_.velocity && !params_.open_loop_control));
  const bool has_feedback = states_.position && states_.velocity;
  if (commands_.velocity && is_single && !has_feedback) {
    RCLCPP_ERROR(logger,
                 "'velocity' command interface can only be used alone if 'velocity' and "
                 "'position' state interfaces are present");
    return false;
  }
  if (commands_.effort && !has_feedback) {
    RCLCPP_ERROR(logger,
                 "'effort' command interface can only be used alone or with 'position' command "
                 "interface if 'velocity' and 'position' state interfaces are present");
    return false;
  }
  if (brakes_on_cancel_ && !states_.velocity) {
    RCLCPP_WARN(logger,
                "Decelerate on cancel is enabled but hardware does not support velocity state "
                "interface. Falling back to hold position on cancel.");
    brakes_on_cancel_ = false;
  }
  if (uses_pids_) {
    pids_.resize(command_joints_.size());
    ff_velocity_scale_.resize(command_joints_.size());
    update_pids();
  }
  return true;
}

void JointTrajectoryController::update_pids() {
  for (size_t i = 0; i < command_joints_.size(); ++i) {
    const Params::Gains& gains = params_.gains.at(params_.joints[command_places_[i]]);
    control_toolbox::AntiWindupStrategy strategy;
    strategy.set_type(gains.antiwindup_strategy);
    strategy.i_max = std::isfinite(gains.i_clamp_max) ? gains.i_clamp_max : gains.i_clamp;
    strategy.i_min = std::isfinite(gains.i_clamp_min) ? gains.i_clamp_min : -gains.i_clamp;
    strategy.error_deadband = gains.error_deadband;
    strategy.tracking_time_constant = gains.tracking_time_constant;
    if (!pids_[i]) pids_[i] = std::make_shared<control_toolbox::Pid>();
    pids_[i]->set_gains(gains.p, gains.i, gains.d, gains.u_clamp_max, gains.u_clamp_min, strategy);
    ff_velocity_scale_[i] = gains.ff_velocity_scale;
  }
}

void JointTrajectoryController::log_interfaces() const {
  RCLCPP_INFO(get_node()->get_logger(),
              "Command interfaces are [%s] and state interfaces are [%s].",
              joined(params_.command_interfaces).c_str(), joined(params_.state_interfaces).c_str());
}

SegmentTolerances JointTrajectoryController::tolerances_of_parameters() const {
  SegmentTolerances tolerances(params_.joints.size());
  tolerances.goal_time_tolerance = params_.constraints.goal_time;
  for (size_t i = 0; i < params_.joints.size(); ++i) {
    const Params::JointConstraints& joint = params_.constraints.joints.at(params_.joints[i]);
    tolerances.state_tolerance[i].position = joint.trajectory;
    tolerances.goal_state_tolerance[i].position = joint.goal;
    tolerances.goal_state_tolerance[i].velocity = params_.constraints.stopped_velocity_tolerance;
  }
  return tolerances;
}

void JointTrajectoryController::create_topics() {
  const auto node = get_node();
  trajectory_subscription_ = node->create_subscription<Trajectory>(
      "~/joint_trajectory", rclcpp::SystemDefaultsQoS(),
      [this](const std::shared_ptr<Trajectory> message) { on_trajectory(message); });
  state_publisher_ = std::make_shared<realtime_tools::RealtimePublisher<StateMessage>>(
      node->create_publisher<StateMessage>("~/controller_state", rclcpp::SystemDefaultsQoS()));
  state_message_ = StateMessage();
  state_message_.joint_names = params_.joints;

  const std::vector<double> zeros(params_.joints.size(), 0.0);
  state_ = wanted_ = error_ = next_ = PathPoint();
  for (PathPoint* point : {&state_, &wanted_, &error_}) {
    point->positions = zeros;
    if (states_.velocity) point->velocities = zeros;
    if (states_.acceleration) point->accelerations = zeros;
  }
}

void JointTrajectoryController::create_services() {
  const auto node = get_node();
  const auto logger = node->get_logger();
  if (params_.allow_partial_joints_goal) {
    RCLCPP_INFO(logger, "Goals with partial set of joints are allowed");
  }
  RCLCPP_INFO(logger, "Action status changes will be monitored at %.2f Hz.",
              params_.action_monitor_rate);
  const std::string name = node->get_name();
  action_server_ = rclcpp_action::create_server<Action>(
      node, name + "/follow_joint_trajectory",
      [this](const rclcpp_action::GoalUUID&, std::shared_ptr<const Action::Goal> goal) {
        return on_goal(goal);
      },
      [this](const std::shared_ptr<GoalHandle> goal) { return on_cancel(goal); },
      [this](const std::shared_ptr<GoalHandle> goal) { on_accepted(goal); });
  query_service_ = node->create_service<QueryState>(
      name + "/query_state",
      [this](const std::shared_ptr<QueryState::Request> request,
             std::shared_ptr<QueryState::Response> response) { on_query(*request, *response); });
}

void JointTrajectoryController::set_up_scaling() {
  const auto logger = get_node()->get_logger();
  const auto& scaling = params_.speed_scaling;
  scaling_factor_ = 1.0;
  if (!commands_.velocity && !commands_.acceleration && !commands_.effort) {
    rclcpp::SystemDefaultsQoS qos;
    qos.transient_local();
    scaling_subscription_ = get_node()->create_subscription<control_msgs::msg::SpeedScalingFactor>(
        "~/speed_scaling_input", qos,
        [this](const std::shared_ptr<control_msgs::msg::SpeedScalingFactor> message) {
          set_scaling_factor(message->factor);
        });
    RCLCPP_INFO(logger, "Setting initial scaling factor to %2f", scaling.initial_scaling_factor);
    scaling_factor_ = scaling.initial_scaling_factor;
  } else if (scaling.initial_scaling_factor != 1.0) {
    RCLCPP_WARN(
        logger,
        "Speed scaling is currently only supported for position interfaces. If you want to make "
        "use of speed scaling, please only use a position interface when configuring this "
        "controller.");
  }
  if (scaling.state_interface.empty()) {
    RCLCPP_INFO(logger,
                "No scaling interface set. This controller will not read speed scaling from the "
                "hardware.");
  } else {
    RCLCPP_INFO(logger, "Using scaling state from the hardware from interface %s.",
                scaling.state_interface.c_str());
  }
  scaling_factor_command_ = scaling_factor_;
}

bool JointTrajectoryController::find_scaling_interfaces() {
  const auto find = [this](auto& interfaces, const std::string& name, const char* what,
                           auto& found) {
    found.reset();
    if (name.empty()) return true;
    for (auto& interface : interfaces) {
      if (interface.get_name() == name) found = std::ref(interface);
    }
    if (!found) {
      RCLCPP_ERROR(get_node()->get_logger(),
                   "Did not find speed scaling interface '%s' in %s interfaces.", name.c_str(),
                   what);
    }
    return found.has_value();
  };
  return find(state_interfaces_, params_.speed_scaling.state_interface, "state", scaling_state_) &&
         find(command_interfaces_, params_.speed_scaling.command_interface, "command",
              scaling_command_);
}

void JointTrajectoryController::choose_timeout() {
  cmd_timeout_ = params_.cmd_timeout;
  if (cmd_timeout_ <= 0.0 || cmd_timeout_ > default_tolerances_.goal_time_tolerance) return;
  RCLCPP_WARN(get_node()->get_logger(),
              "Command timeout must be higher than goal_time tolerance (%f vs. %f)", cmd_timeout_,
              default_tolerances_.goal_time_tolerance);
  cmd_timeout_ = 0.0;
}

CallbackReturn JointTrajectoryController::on_activate(const rclcpp_lifecycle::State&) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  param_listener_->refresh_dynamic_parameters();
  params_ = param_listener_->get_params();
  default_tolerances_ = tolerances_of_parameters();
  if (!find_scaling_interfaces() || !take_interfaces()) return CallbackReturn::ERROR;

  read_state(state_);
  if (params_.set_last_command_interface_value_as_state_on_activation &&
      command_joints_.size() == params_.joints.size()) {
    read_commands_as_state(state_);
  }
  last_command_ = state_;
  last_command_time_.reset();
  for (const auto& pid : pids_) pid->reset();
  path_.emplace();
  hold();
  choose_timeout();
  return CallbackReturn::SUCCESS;
}

CallbackReturn JointTrajectoryController::on_deactivate(const rclcpp_lifecycle::State&) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (goal_) {
    auto result = std::make_shared<Action::Result>();
    result->error_code = Action::Result::INVALID_GOAL;
    result->error_string = "Current goal cancelled during deactivate transition.";
    goal_->setAborted(result);  // the timer tells the client
    goal_.reset();
  }
  stop_commands();
  scaling_state_.reset();
  scaling_command_.reset();
  path_.reset();
  new_request_.reset();
  return CallbackReturn::SUCCESS;
}

CallbackReturn JointTrajectoryController::on_error(const rclcpp_lifecycle::State&) {
  reset();
  return CallbackReturn::SUCCESS;
}

void JointTrajectoryController::reset() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  trajectory_subscription_.reset();
  for (const auto& pid : pids_) {
    if (pid) pid->reset();
  }
  path_.reset();
  new_request_.reset();
}

}  // namespace joint_trajectory_controller
