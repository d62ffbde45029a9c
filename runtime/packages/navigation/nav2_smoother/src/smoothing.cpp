// The goals of the smoother server.
#include <algorithm>

#include "nav2_smoother/nav2_smoother.hpp"
#include "nav2_util/validate_messages.hpp"
#include "nav_2d_utils/conversions.hpp"

namespace nav2_smoother {
namespace {

using Result = nav2_msgs::action::SmoothPath::Result;

template <typename ErrorT>
bool is(const std::exception& error) {
  return dynamic_cast<const ErrorT*>(&error) != nullptr;
}

uint16_t code_of(const std::exception& error) {
  if (is<nav2_core::InvalidSmoother>(error)) return Result::INVALID_SMOOTHER;
  if (is<nav2_core::SmootherTimedOut>(error)) return Result::TIMEOUT;
  if (is<nav2_core::SmoothedPathInCollision>(error)) return Result::SMOOTHED_PATH_IN_COLLISION;
  if (is<nav2_core::FailedToSmoothPath>(error)) return Result::FAILED_TO_SMOOTH_PATH;
  if (is<nav2_core::InvalidPath>(error)) return Result::INVALID_PATH;
  return Result::UNKNOWN;
}

bool is_finite(const geometry_msgs::msg::PoseStamped& stamped) {
  const auto& turn = stamped.pose.orientation;
  return nav2_util::validateMsg(stamped.pose.position) && nav2_util::validateMsg(turn.x) &&
         nav2_util::validateMsg(turn.y) && nav2_util::validateMsg(turn.z) &&
         nav2_util::validateMsg(turn.w);
}

}  // namespace

bool SmootherServer::findSmootherId(const std::string& c_name, std::string& name) {
  if (smoothers_.count(c_name) != 0) {
    RCLCPP_DEBUG(get_logger(), "Selected smoother: %s.", c_name.c_str());
    name = c_name;
    return true;
  }
  if (smoothers_.size() == 1 && c_name.empty()) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "No smoother was specified in action call. Server will use only plugin loaded "
                     "%s. This warning will appear once.",
                     smoother_ids_concat_.c_str());
    name = smoothers_.begin()->first;
    return true;
  }
  RCLCPP_ERROR(get_logger(),
               "SmoothPath called with smoother name %s, which does not exist. Available smoothers "
               "are: %s.",
               c_name.c_str(), smoother_ids_concat_.c_str());
  return false;
}

bool SmootherServer::validate(const nav_msgs::msg::Path& path) {
  if (path.poses.empty()) {
    RCLCPP_WARN(get_logger(), "Requested path to smooth is empty");
    return false;
  }
  if (!std::all_of(path.poses.begin(), path.poses.end(), is_finite)) {
    RCLCPP_WARN(get_logger(), "Requested path to smooth contains NaNs or Infs");
    return false;
  }
  RCLCPP_DEBUG(get_logger(), "Requested path to smooth is valid");
  return true;
}

void SmootherServer::smoothPlan() {
  RCLCPP_INFO(get_logger(), "Received a path to smooth.");
  const auto goal = action_server_->get_current_goal();
  if (!goal) return;
  auto result = std::make_shared<ActionResult>();
  try {
    smoothGoal(*goal, *result);
    action_server_->succeeded_current(result);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(), "%s", error.what());
    result->error_code = code_of(error);
    result->error_msg = error.what();
    action_server_->terminate_current(result);
  }
}

void SmootherServer::smoothGoal(const Action::Goal& goal, ActionResult& result) {
  const rclcpp::Time start = now();
  if (!findSmootherId(goal.smoother_id, current_smoother_)) {
    throw nav2_core::InvalidSmoother("Invalid Smoother: " + goal.smoother_id);
  }
  result.path = goal.path;
  if (!validate(result.path)) {
    throw nav2_core::InvalidPath("Requested path to smooth is invalid");
  }
  const rclcpp::Duration most(goal.max_smoothing_duration);
  result.was_completed = smoothers_.at(current_smoother_)->smooth(result.path, most);
  const rclcpp::Duration taken = now() - start;
  result.smoothing_duration = taken;
  if (!result.was_completed) {
    RCLCPP_INFO(get_logger(),
                "Smoother %s did not complete smoothing in specified time limit(%lf seconds) and "
                "was interrupted after %lf seconds",
                current_smoother_.c_str(), most.seconds(), taken.seconds());
  }
  plan_publisher_->publish(result.path);
  if (goal.check_for_collisions) checkCollisions(result.path);
  RCLCPP_DEBUG(get_logger(), "Smoother succeeded (time: %lf), setting result", taken.seconds());
}

void SmootherServer::checkCollisions(const nav_msgs::msg::Path& path) {
  // All poses are checked against one costmap.
  bool is_first = true;
  for (const auto& stamped : path.poses) {
    const geometry_msgs::msg::Pose2D pose = nav_2d_utils::poseToPose2D(stamped.pose);
    if (!collision_checker_->isCollisionFree(pose, is_first)) {
      RCLCPP_ERROR(get_logger(), "Smoothed path leads to a collision at x: %lf, y: %lf, theta: %lf",
                   pose.x, pose.y, pose.theta);
      throw nav2_core::SmoothedPathInCollision(
          "Smoothed Path collided atX: " + std::to_string(pose.x) + "Y: " + std::to_string(pose.y) +
          "Theta: " + std::to_string(pose.theta));
    }
    is_first = false;
  }
}

}  // namespace nav2_smoother
