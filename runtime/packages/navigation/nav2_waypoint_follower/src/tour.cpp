// See waypoint_follower.hpp. The work of a goal: waypoint after waypoint, each with its task.
#include <chrono>
#include <mutex>
#include <utility>

#include "nav2_waypoint_follower/waypoint_follower.hpp"

namespace nav2_waypoint_follower {

using Result = nav2_msgs::action::FollowWaypoints::Result;

namespace {

nav2_msgs::msg::MissedWaypoint missed_waypoint(uint32_t index,
                                               const geometry_msgs::msg::PoseStamped& pose,
                                               int error_code) {
  nav2_msgs::msg::MissedWaypoint missed;
  missed.index = index;
  missed.goal = pose;
  missed.error_code = static_cast<uint16_t>(error_code);
  return missed;
}

}  // namespace

void WaypointFollower::followWaypointsCallback() {
  followWaypointsHandler<ActionServer, ActionT>(*xyz_action_server_);
}

void WaypointFollower::followGPSWaypointsCallback() {
  followWaypointsHandler<ActionServerGPS, ActionTGPS>(*gps_action_server_);
}

WaypointFollower::Poses WaypointFollower::posesOf(const ActionT::Goal& goal) {
  return goal.poses;
}

WaypointFollower::Poses WaypointFollower::posesOf(const ActionTGPS::Goal& goal) {
  return convertGPSPosesToMapPoses(goal.gps_poses);
}

template <typename ServerT, typename FollowT>
void WaypointFollower::followWaypointsHandler(ServerT& server) {
  const auto result = std::make_shared<typename FollowT::Result>();
  const auto feedback = std::make_shared<typename FollowT::Feedback>();
  auto goal = server.get_current_goal();
  if (!goal || !server.is_server_active()) return;
  const std::unique_lock<std::mutex> turn(tour_mutex_, std::try_to_lock);
  if (!turn) {
    RCLCPP_ERROR(get_logger(),
                 "A goal of the other action is being followed. Cancel it first. Terminating this "
                 "goal.");
    server.terminate_current(result);
    return;
  }
  current_goal_status_ = {};
  Tour tour{posesOf(*goal), goal->goal_index, 0, goal->number_of_loops, true};
  RCLCPP_INFO(get_logger(), "Received follow waypoint request with %i waypoints.",
              static_cast<int>(tour.poses.size()));
  rclcpp::WallRate rate(loop_rate_);
  while (rclcpp::ok() && server.is_server_active()) {
    if (server.is_cancel_requested()) {
      cancelNavigation();
      server.terminate_all();
      return;
    }
    if (server.is_preempt_requested()) {
      RCLCPP_INFO(get_logger(), "Preempting the goal pose.");
      goal = server.accept_pending_goal();
      if (!goal) continue;
      tour = Tour{posesOf(*goal), 0, 0, goal->number_of_loops, true};
      result->missed_waypoints.clear();
    }
    if (tour.is_at_new_waypoint) {
      if (!isUsable(tour)) {
        // Navigation to a waypoint of the goal that this one preempted.
        if (current_goal_status_.status == ActionStatus::PROCESSING) cancelNavigation();
        server.terminate_current(result);
        return;
      }
      current_goal_status_ = {ActionStatus::PROCESSING, 0};
    }
    // A goal without a server would be lost.
    if (tour.is_at_new_waypoint && nav_to_pose_client_->action_server_is_ready()) {
      tour.is_at_new_waypoint = false;
      navigateTo(tour.poses[tour.index]);
    } else if (tour.is_at_new_waypoint) {
      RCLCPP_INFO_THROTTLE(get_logger(), *get_clock(), 5000,
                           "Waiting for the action server navigate_to_pose");
    }
    feedback->current_waypoint = tour.index;
    server.publish_feedback(feedback);

    const Step next = step(tour, result->missed_waypoints);
    if (next == Step::kStop) {
      server.terminate_current(result);
      return;
    }
    if (next == Step::kNext && !advance(tour)) {
      server.succeeded_current(result);
      return;
    }
    callback_group_executor_.spin_some();
    rate.sleep();
  }
  cancelNavigation();
}

bool WaypointFollower::isUsable(const Tour& tour) {
  if (tour.poses.empty()) {
    RCLCPP_ERROR(get_logger(),
                 "Empty vector of waypoints passed to waypoint following "
                 "action potentially due to conversation failure or empty request.");
    return false;
  }
  if (tour.index >= tour.poses.size()) {
    RCLCPP_ERROR(get_logger(), "Waypoint %u does not exist; the last one is %zu.", tour.index,
                 tour.poses.size() - 1);
    return false;
  }
  return true;
}

void WaypointFollower::navigateTo(const geometry_msgs::msg::PoseStamped& pose) {
  const uint64_t number = ++last_goal_;
  rclcpp_action::Client<ClientT>::SendGoalOptions options;
  options.goal_response_callback =
      [this, number](const rclcpp_action::ClientGoalHandle<ClientT>::SharedPtr& handle) {
        if (handle || number != last_goal_) return;
        RCLCPP_ERROR(get_logger(), "navigate_to_pose action client failed to send goal to server.");
        current_goal_status_.status = ActionStatus::FAILED;
      };
  options.result_callback =
      [this, number](const rclcpp_action::ClientGoalHandle<ClientT>::WrappedResult& result) {
        if (number != last_goal_) return;
        switch (result.code) {
          case rclcpp_action::ResultCode::SUCCEEDED:
            current_goal_status_.status = ActionStatus::SUCCEEDED;
            return;
          case rclcpp_action::ResultCode::ABORTED:
            current_goal_status_ = {ActionStatus::FAILED, result.result->error_code};
            return;
          case rclcpp_action::ResultCode::CANCELED:
            current_goal_status_.status = ActionStatus::FAILED;
            return;
          case rclcpp_action::ResultCode::UNKNOWN:
            break;
        }
        RCLCPP_ERROR(get_logger(), "Received an UNKNOWN result code from navigation action!");
        current_goal_status_.status = ActionStatus::UNKNOWN;
      };
  ClientT::Goal goal;
  goal.pose = pose;
  goal.pose.header.stamp = now();
  nav_to_pose_client_->async_send_goal(goal, options);
}

void WaypointFollower::cancelNavigation() {
  ++last_goal_;
  if (!rclcpp::ok() || !nav_to_pose_client_->action_server_is_ready()) return;
  auto cancelled = nav_to_pose_client_->async_cancel_all_goals();
  callback_group_executor_.spin_until_future_complete(cancelled);
  callback_group_executor_.spin_some();
}

WaypointFollower::Step WaypointFollower::step(const Tour& tour, Missed& missed) {
  switch (current_goal_status_.status) {
    case ActionStatus::PROCESSING:
      return Step::kWait;
    case ActionStatus::SUCCEEDED:
      return stepAfterArrival(tour, missed);
    case ActionStatus::FAILED:
    case ActionStatus::UNKNOWN:
      return stepAfterFailure(tour, missed);
  }
  return Step::kWait;
}

WaypointFollower::Step WaypointFollower::stepAfterFailure(const Tour& tour, Missed& missed) {
  missed.push_back(
      missed_waypoint(tour.index, tour.poses[tour.index], current_goal_status_.error_code));
  if (stop_on_failure_) {
    RCLCPP_WARN(get_logger(),
                "Failed to process waypoint %i in waypoint list and stop on failure is enabled."
                " Terminating action.",
                tour.index);
    return Step::kStop;
  }
  RCLCPP_INFO(get_logger(), "Failed to process waypoint %i, moving to next.", tour.index);
  return Step::kNext;
}

WaypointFollower::Step WaypointFollower::stepAfterArrival(const Tour& tour, Missed& missed) {
  const int index = static_cast<int>(tour.index);
  const geometry_msgs::msg::PoseStamped& pose = tour.poses[tour.index];
  RCLCPP_INFO(get_logger(), "Succeeded processing waypoint %i, processing waypoint task execution",
              index);
  const bool is_done = waypoint_task_executor_->processAtWaypoint(pose, index);
  RCLCPP_INFO(get_logger(), "Task execution at waypoint %i %s", index,
              is_done ? "succeeded" : "failed!");
  if (!is_done) {
    missed.push_back(missed_waypoint(tour.index, pose, Result::TASK_EXECUTOR_FAILED));
  }
  if (!is_done && stop_on_failure_) {
    RCLCPP_WARN(get_logger(),
                "Failed to execute task at waypoint %i  stop on failure is enabled."
                " Terminating action.",
                index);
    return Step::kStop;
  }
  RCLCPP_INFO(get_logger(), "Handled task execution on waypoint %i, moving to next.", index);
  return Step::kNext;
}

bool WaypointFollower::advance(Tour& tour) {
  tour.is_at_new_waypoint = true;
  if (++tour.index < tour.poses.size()) return true;
  if (tour.loop == tour.loops) {
    RCLCPP_INFO(get_logger(), "Completed all %zu waypoints requested.", tour.poses.size());
    return false;
  }
  RCLCPP_INFO(get_logger(), "Starting a new loop, current loop count is %i", tour.loop);
  tour.index = 0;
  ++tour.loop;
  return true;
}

WaypointFollower::Poses WaypointFollower::convertGPSPosesToMapPoses(
    const std::vector<geographic_msgs::msg::GeoPose>& gps_poses) {
  const char* frame = global_frame_id_.c_str();
  RCLCPP_INFO(get_logger(), "Converting GPS waypoints to %s Frame..", frame);
  Poses poses;
  for (size_t i = 0; i < gps_poses.size(); ++i) {
    auto request = std::make_shared<robot_localization::srv::FromLL::Request>();
    auto response = std::make_shared<robot_localization::srv::FromLL::Response>();
    request->ll_point = gps_poses[i].position;
    from_ll_to_map_client_->wait_for_service(std::chrono::seconds(1));
    if (from_ll_to_map_client_->invoke(request, response)) {
      geometry_msgs::msg::PoseStamped& pose = poses.emplace_back();
      pose.header.frame_id = global_frame_id_;
      pose.header.stamp = now();
      pose.pose.position = response->map_point;
      pose.pose.orientation = gps_poses[i].orientation;
      continue;
    }
    RCLCPP_ERROR(get_logger(),
                 "fromLL service of robot_localization could not convert %zu th GPS waypoint to"
                 "%s frame, going to skip this point!"
                 "Make sure you have run navsat_transform_node of robot_localization",
                 i, frame);
    if (!stop_on_failure_) continue;
    RCLCPP_ERROR(get_logger(),
                 "Conversion of %zu th GPS waypoint to"
                 "%s frame failed and stop_on_failure is set to true"
                 "Not going to execute any of waypoints, exiting with failure!",
                 i, frame);
    return {};
  }
  RCLCPP_INFO(get_logger(), "Converted all %zu GPS waypoint to %s frame", poses.size(), frame);
  return poses;
}

}  // namespace nav2_waypoint_follower
