// The cycle of JointTrajectoryController: sample, judge, command, report.
#include "joint_trajectory_controller/joint_trajectory_controller.hpp"

#include <cmath>

#include "pluginlib/class_list_macros.hpp"

namespace joint_trajectory_controller {

using controller_interface::return_type;

return_type JointTrajectoryController::update(const rclcpp::Time& time,
                                              const rclcpp::Duration& period) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  read_scaling();
  follow_parameters();
  if (!path_) return return_type::OK;
  start_new_trajectory();
  state_.from_start_ns = 0;
  read_state(state_);
  if (path_->has_request()) follow_trajectory(time, period);
  publish_state(time);
  return return_type::OK;
}

void JointTrajectoryController::read_scaling() {
  if (scaling_state_) {
    scaling_factor_ = scaling_state_->get().get_optional().value_or(scaling_factor_);
  }
  if (scaling_command_ && !scaling_command_->get().set_value(scaling_factor_command_)) {
    RCLCPP_ERROR(get_node()->get_logger(),
                 "Could not set speed scaling factor through command interfaces.");
  }
}

void JointTrajectoryController::follow_parameters() {
  if (!param_listener_->try_update_params(params_)) return;
  default_tolerances_ = tolerances_of_parameters();
  if (uses_pids_) update_pids();
}

void JointTrajectoryController::start_new_trajectory() {
  if (!new_request_) return;
  // Joints that a goal does not name stay where they were sent last, or where they are.
  std::vector<double> positions = state_.positions;
  if (commands_.position) {
    const std::vector<double> commanded = commands_of(0);
    for (size_t i = 0; i < positions.size(); ++i) {
      if (!std::isnan(commanded[i])) positions[i] = commanded[i];
    }
  }
  complete_and_sort(*new_request_, params_.joints, positions);
  path_->start(std::move(new_request_));
  new_request_.reset();
}

void JointTrajectoryController::prepare_first_sample(const rclcpp::Time& time) {
  path_time_ = time;
  if (params_.interpolate_from_desired_state || params_.open_loop_control) {
    if (!last_command_time_) last_command_time_ = time;
    path_->set_point_before(last_command_time_->nanoseconds(), last_command_, wraps_);
  } else {
    path_->set_point_before(time.nanoseconds(), state_, wraps_);
  }
}

void JointTrajectoryController::follow_trajectory(const rclcpp::Time& time,
                                                  const rclcpp::Duration& period) {
  const bool is_first_sample = !path_->is_sampled();
  if (is_first_sample) {
    prepare_first_sample(time);
  } else {
    path_time_ = path_time_ + period * scaling_factor_;
  }
  path_->sample(path_time_.nanoseconds(), interpolation_, wanted_);
  wanted_.from_start_ns = path_time_.nanoseconds() - path_->start_ns();
  const auto segment = path_->sample((path_time_ + update_period_).nanoseconds(), interpolation_,
                                     next_, /*only_looks=*/true);
  state_.from_start_ns = time.nanoseconds() - path_->start_ns();
  if (!segment) return;

  update_error();
  const Judgement judgement = judge(*segment, is_first_sample);
  check_timeout(judgement);
  if (!judgement.is_violated_on_the_way && judgement.is_in_time) {
    write_commands(period);
    last_command_ = next_;
    last_command_time_ = time;
  }
  if (goal_) {
    report_feedback(time);
    end_goal(judgement);
  } else {
    end_without_goal(judgement);
  }
}

void JointTrajectoryController::update_error() {
  const size_t joints = params_.joints.size();
  error_.positions.resize(joints);
  for (size_t i = 0; i < joints; ++i) {
    error_.positions[i] =
        position_error(wanted_.positions[i], state_.positions[i], i < wraps_.size() && wraps_[i]);
    if (states_.velocity && (commands_.velocity || commands_.effort)) {
      error_.velocities[i] = wanted_.velocities[i] - state_.velocities[i];
    }
    if (states_.acceleration && commands_.acceleration) {
      error_.accelerations[i] = wanted_.accelerations[i] - state_.accelerations[i];
    }
  }
}

JointTrajectoryController::Judgement JointTrajectoryController::judge(const Segment& segment,
                                                                      bool is_first_sample) {
  const auto say = [this](size_t joint, const StateTolerances& tolerances) {
    const auto logger = rclcpp::get_logger("tolerances");
    for (const std::string& line : explain(error_, joint, tolerances)) {
      RCLCPP_ERROR(logger, "%s", line.c_str());
    }
  };
  Judgement judgement;
  judgement.is_over = path_->is_over(segment);
  judgement.late_s =
      static_cast<double>(path_time_.nanoseconds() - path_->time_of(segment.begin)) * 1e-9;
  if (is_holding_) return judgement;
  for (size_t i = 0; i < params_.joints.size(); ++i) {
    const StateTolerances& on_the_way = active_tolerances_.state_tolerance[i];
    const StateTolerances& at_the_end = active_tolerances_.goal_state_tolerance[i];
    if ((!judgement.is_over || is_first_sample) && !is_within(error_, i, on_the_way)) {
      judgement.is_violated_on_the_way = true;
      say(i, on_the_way);
    }
    if (!judgement.is_over || is_within(error_, i, at_the_end)) continue;
    judgement.is_outside_goal = true;
    const double limit_s = active_tolerances_.goal_time_tolerance;
    if (limit_s != 0.0 && judgement.late_s > limit_s) {
      judgement.is_in_time = false;
      say(i, at_the_end);
    }
  }
  return judgement;
}

void JointTrajectoryController::check_timeout(const Judgement& judgement) {
  if (!judgement.is_over || is_holding_ || cmd_timeout_ <= 0.0) return;
  if (judgement.late_s <= cmd_timeout_) return;
  RCLCPP_WARN(get_node()->get_logger(), "Aborted due to command timeout");
  hold_or_brake();
}

void JointTrajectoryController::report_feedback(const rclcpp::Time& time) {
  // A copy: the timer publishes it later.
  auto feedback = std::make_shared<Action::Feedback>();
  feedback->header.stamp = time;
  feedback->joint_names = params_.joints;
  feedback->actual = to_message(state_);
  feedback->desired = to_message(wanted_);
  feedback->error = to_message(error_);
  goal_->setFeedback(feedback);
}

void JointTrajectoryController::end_goal(const Judgement& judgement) {
  const auto logger = get_node()->get_logger();
  auto result = std::make_shared<Action::Result>();
  if (judgement.is_violated_on_the_way) {
    result->error_code = Action::Result::PATH_TOLERANCE_VIOLATED;
    result->error_string = "Aborted due to path tolerance violation";
    goal_->setAborted(result);
    RCLCPP_WARN(logger, "Aborted due to state tolerance violation");
    hold_or_brake();
  } else if (judgement.is_over && !judgement.is_outside_goal) {
    result->error_code = Action::Result::SUCCESSFUL;
    result->error_string = "Goal successfully reached!";
    goal_->setSucceeded(result);
    RCLCPP_INFO(logger, "Goal reached, success!");
    repeat_last_point();
  } else if (judgement.is_over && !judgement.is_in_time) {
    result->error_code = Action::Result::GOAL_TOLERANCE_VIOLATED;
    result->error_string = "Aborted due to goal_time_tolerance exceeding by " +
                           std::to_string(judgement.late_s) + " seconds";
    goal_->setAborted(result);
    RCLCPP_WARN(logger, "%s", result->error_string.c_str());
    hold_or_brake();
  } else {
    return;
  }
  goal_.reset();
}

void JointTrajectoryController::end_without_goal(const Judgement& judgement) {
  if (judgement.is_violated_on_the_way) {
    RCLCPP_ERROR(get_node()->get_logger(), "Holding position due to state tolerance violation");
    hold_or_brake();
  } else if (judgement.is_over && !judgement.is_in_time) {
    RCLCPP_ERROR(get_node()->get_logger(), "Exceeded goal_time_tolerance: holding position...");
    hold_or_brake();
  }
}

}  // namespace joint_trajectory_controller

PLUGINLIB_EXPORT_CLASS(joint_trajectory_controller::JointTrajectoryController,
                       controller_interface::ControllerInterface)
