// Trajectories and goals that come to JointTrajectoryController, and what it does without one.
#include <chrono>
#include <utility>

#include "joint_trajectory_controller/joint_trajectory_controller.hpp"
#include "joint_trajectory_controller/trajectory_checks.hpp"
#include "lifecycle_msgs/msg/state.hpp"

namespace joint_trajectory_controller {
namespace {

constexpr int64_t kNsPerSecond = 1'000'000'000;

template <class StampT>
int64_t nanoseconds(const StampT& stamp) {
  return static_cast<int64_t>(stamp.sec) * kNsPerSecond + stamp.nanosec;
}

}  // namespace

PathPoint to_point(const trajectory_msgs::msg::JointTrajectoryPoint& message) {
  return {message.positions, message.velocities, message.accelerations, message.effort,
          nanoseconds(message.time_from_start)};
}

trajectory_msgs::msg::JointTrajectoryPoint to_message(const PathPoint& point) {
  trajectory_msgs::msg::JointTrajectoryPoint message;
  message.positions = point.positions;
  message.velocities = point.velocities;
  message.accelerations = point.accelerations;
  message.effort = point.effort;
  message.time_from_start = rclcpp::Duration::from_nanoseconds(point.from_start_ns);
  return message;
}

PathRequest to_request(const trajectory_msgs::msg::JointTrajectory& message) {
  PathRequest request;
  request.joints = message.joint_names;
  request.start_ns = nanoseconds(message.header.stamp);
  for (const auto& point : message.points) request.points.push_back(to_point(point));
  return request;
}

bool JointTrajectoryController::is_accepted(const PathRequest& request) const {
  TrajectoryRules rules;
  rules.joints = params_.joints;
  rules.allows_partial_joints = params_.allow_partial_joints_goal;
  rules.allows_nonzero_end_velocity = params_.allow_nonzero_velocity_at_trajectory_end;
  rules.allows_integration = params_.allow_integration_in_goal_trajectories;
  rules.has_effort_command = commands_.effort;
  rules.now_ns = get_node()->now().nanoseconds();
  const std::string why = why_refused(request, rules);
  if (!why.empty()) RCLCPP_ERROR(get_node()->get_logger(), "%s", why.c_str());
  return why.empty();
}

void JointTrajectoryController::on_trajectory(const std::shared_ptr<Trajectory>& message) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  auto request = std::make_shared<PathRequest>(to_request(*message));
  if (!is_accepted(*request) || !path_) return;
  new_request_ = std::move(request);
  is_holding_ = false;
}

rclcpp_action::GoalResponse JointTrajectoryController::on_goal(
    const std::shared_ptr<const Action::Goal>& goal) {
  const auto logger = get_node()->get_logger();
  RCLCPP_INFO(logger, "Received new action goal");
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!path_) {
    RCLCPP_ERROR(logger, "Can't accept new action goals. Controller is not running.");
    return rclcpp_action::GoalResponse::REJECT;
  }
  if (!is_accepted(to_request(goal->trajectory))) return rclcpp_action::GoalResponse::REJECT;
  RCLCPP_INFO(logger, "Accepted new action goal");
  return rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
}

rclcpp_action::CancelResponse JointTrajectoryController::on_cancel(
    const std::shared_ptr<GoalHandle>& goal) {
  const auto logger = get_node()->get_logger();
  RCLCPP_INFO(logger, "Got request to cancel goal");
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (goal_ && goal_->gh_ == goal) {
    RCLCPP_INFO(logger, "Canceling active action goal because cancel callback received.");
    goal_->setCanceled(std::make_shared<Action::Result>());
    goal_.reset();
    hold_or_brake();
  }
  return rclcpp_action::CancelResponse::ACCEPT;
}

void JointTrajectoryController::on_accepted(const std::shared_ptr<GoalHandle>& handle) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (goal_) {
    auto result = std::make_shared<Action::Result>();
    result->error_code = Action::Result::INVALID_GOAL;
    result->error_string = "Current goal preempted by new incoming action.";
    goal_->setAborted(result);
  }
  // Also for one that has just ended: its timer goes.
  if (watched_goal_) watched_goal_->runNonRealtime();
  const Action::Goal& goal = *handle->get_goal();
  new_request_ = std::make_shared<PathRequest>(to_request(goal.trajectory));
  is_holding_ = false;

  GoalTolerances tolerances;
  for (const auto& one : goal.path_tolerance) {
    tolerances.path.push_back({one.name, {one.position, one.velocity, one.acceleration}});
  }
  for (const auto& one : goal.goal_tolerance) {
    tolerances.goal.push_back({one.name, {one.position, one.velocity, one.acceleration}});
  }
  tolerances.goal_time_s = rclcpp::Duration(goal.goal_time_tolerance).seconds();
  std::string problem;
  active_tolerances_ = segment_tolerances(default_tolerances_, tolerances, params_.joints, problem);
  if (!problem.empty()) {
    RCLCPP_ERROR(get_node()->get_logger().get_child("tolerance"), "%s", problem.c_str());
  }

  goal_ = std::make_shared<RealtimeGoal>(handle);
  goal_->execute();
  watch_goal(goal_);
}

void JointTrajectoryController::watch_goal(const std::shared_ptr<RealtimeGoal>& goal) {
  watched_goal_ = goal;
  const auto period = std::chrono::duration_cast<std::chrono::nanoseconds>(
      std::chrono::duration<double>(1.0 / params_.action_monitor_rate));
  goal_timer_ = get_node()->create_wall_timer(period, [this, goal] {
    goal->runNonRealtime();
    if (!goal->gh_->is_active()) goal_timer_->cancel();  // nothing more to tell
  });
}

void JointTrajectoryController::on_query(const QueryState::Request& request,
                                         QueryState::Response& response) {
  const auto logger = get_node()->get_logger();
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  response.success = false;
  if (!path_) {
    RCLCPP_ERROR(logger, "Can't sample trajectory. Controller is not active.");
    return;
  }
  response.name = params_.joints;
  PathPoint asked = state_;
  if (path_->has_request() && path_->is_sampled()) {
    const auto segment =
        path_->sample(nanoseconds(request.time), interpolation_, asked, /*only_looks=*/true);
    response.success = segment.has_value() && !path_->is_over(*segment);
    if (!segment) {
      RCLCPP_ERROR(logger,
                   "Requested sample time is earlier than the current trajectory start time.");
    } else if (!response.success) {
      RCLCPP_ERROR(logger, "Requested sample time precedes the current trajectory end time.");
    }
  } else {
    RCLCPP_ERROR(logger, "Currently there is no valid trajectory instance.");
  }
  response.position = asked.positions;
  response.velocity = asked.velocities;
  response.acceleration = asked.accelerations;
}

void JointTrajectoryController::set_scaling_factor(double factor) {
  const auto logger = get_node()->get_logger();
  if (factor < 0.0) {
    RCLCPP_WARN(logger, "Scaling factor has to be greater or equal to 0.0 - Ignoring input!");
    return;
  }
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (factor != scaling_factor_) {
    RCLCPP_INFO(get_node()->get_logger().get_child("speed_scaling"),
                "New scaling factor will be %f", factor);
  }
  scaling_factor_ = factor;
  if (params_.speed_scaling.command_interface.empty() &&
      !params_.speed_scaling.state_interface.empty()) {
    RCLCPP_WARN_ONCE(
        logger,
        "Setting the scaling factor while only one-way communication with the hardware is setup. "
        "This will likely get overwritten by the hardware again. If available, please also setup "
        "the speed_scaling_command_interface_name");
    return;
  }
  scaling_factor_command_ = factor;
}

void JointTrajectoryController::start_hold(PathPoint point) {
  auto request = std::make_shared<PathRequest>();
  request->joints = params_.joints;
  point.from_start_ns = 0;
  request->points.push_back(std::move(point));
  new_request_ = std::move(request);
  is_holding_ = true;  // tolerances do not count
}

void JointTrajectoryController::hold() {
  const std::vector<double> zeros(params_.joints.size(), 0.0);
  PathPoint point;
  point.positions = state_.positions;
  // So that the trajectory has each kind that is commanded.
  if (commands_.velocity || commands_.acceleration) point.velocities = zeros;
  if (commands_.acceleration) point.accelerations = zeros;
  if (commands_.effort) point.effort = zeros;
  start_hold(std::move(point));
}

void JointTrajectoryController::hold_or_brake() {
  if (!brakes_on_cancel_) {
    hold();
    return;
  }
  new_request_ = std::make_shared<PathRequest>(
      braking_path(params_.joints, state_, max_deceleration_, update_period_.seconds()));
  is_holding_ = true;
}

void JointTrajectoryController::repeat_last_point() {
  start_hold(path_->request()->points.back());
}

}  // namespace joint_trajectory_controller
