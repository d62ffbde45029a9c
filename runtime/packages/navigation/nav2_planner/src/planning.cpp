// The goals and questions of the planner server.
#include <algorithm>
#include <limits>
#include <utility>

#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_planner/planner_server.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "tf2/utils.h"

namespace nav2_planner {
namespace {

/// The code of an error in the result of an action.
template <typename ResultT>
uint16_t code_of(const std::exception& error) {
  const auto is = [&error](const auto* type) { return dynamic_cast<decltype(type)>(&error); };
  if (is(static_cast<const nav2_core::InvalidPlanner*>(nullptr))) return ResultT::INVALID_PLANNER;
  if (is(static_cast<const nav2_core::StartOccupied*>(nullptr))) return ResultT::START_OCCUPIED;
  if (is(static_cast<const nav2_core::GoalOccupied*>(nullptr))) return ResultT::GOAL_OCCUPIED;
  if (is(static_cast<const nav2_core::NoValidPathCouldBeFound*>(nullptr))) {
    return ResultT::NO_VALID_PATH;
  }
  if (is(static_cast<const nav2_core::PlannerTimedOut*>(nullptr))) return ResultT::TIMEOUT;
  if (is(static_cast<const nav2_core::StartOutsideMapBounds*>(nullptr))) {
    return ResultT::START_OUTSIDE_MAP;
  }
  if (is(static_cast<const nav2_core::GoalOutsideMapBounds*>(nullptr))) {
    return ResultT::GOAL_OUTSIDE_MAP;
  }
  if (is(static_cast<const nav2_core::PlannerTFError*>(nullptr))) return ResultT::TF_ERROR;
  return ResultT::UNKNOWN;
}

bool is_without_viapoints(const std::exception& error) {
  return dynamic_cast<const nav2_core::NoViapointsGiven*>(&error) != nullptr;
}

}  // namespace

void PlannerServer::waitForCostmap(const std::function<bool()>& is_active) {
  rclcpp::Rate rate(100);
  const rclcpp::Time begin = now();
  while (!costmap_ros_->isCurrent()) {
    // The clock may stand.
    if (!rclcpp::ok() || !is_active() || now() - begin > costmap_update_timeout_) {
      throw nav2_core::PlannerTimedOut("Costmap timed out waiting for update");
    }
    rate.sleep();
  }
}

template <typename GoalT>
PlannerServer::Pose PlannerServer::startOf(const GoalT& goal) {
  Pose start;
  if (goal.use_start) return goal.start;
  if (!costmap_ros_->getRobotPose(start)) {
    throw nav2_core::PlannerTFError("Unable to get start pose");
  }
  return start;
}

PlannerServer::Path PlannerServer::planBetween(Pose start, Pose goal, const std::string& planner_id,
                                               const std::function<bool()>& is_cancelled) {
  last_start_ = start;
  last_goal_ = goal;
  Pose global_start;
  Pose global_goal;
  if (!costmap_ros_->transformPoseToGlobalFrame(start, global_start) ||
      !costmap_ros_->transformPoseToGlobalFrame(goal, global_goal)) {
    throw nav2_core::PlannerTFError("Unable to transform poses to global frame");
  }
  Path path = getPlan(global_start, global_goal, planner_id, is_cancelled);
  const double x = global_goal.pose.position.x;
  const double y = global_goal.pose.position.y;
  if (path.poses.empty()) {
    RCLCPP_WARN(get_logger(),
                "Planning algorithm %s failed to generate a valid path to (%.2f, %.2f)",
                planner_id.c_str(), x, y);
    throw nav2_core::NoValidPathCouldBeFound(planner_id + " generated a empty path");
  }
  RCLCPP_DEBUG(get_logger(), "Found valid path of size %zu to (%.2f, %.2f)", path.poses.size(), x,
               y);
  return path;
}

template <typename ActionT, typename PlanT>
void PlannerServer::answer(Server<ActionT>& server, PlanT plan) {
  const std::lock_guard<std::mutex> lock(planning_lock_);
  const rclcpp::Time begin = now();
  auto goal = server.get_current_goal();
  auto result = std::make_shared<typename ActionT::Result>();
  try {
    if (!server.is_server_active()) {
      RCLCPP_DEBUG(get_logger(), "Action server unavailable or inactive. Stopping.");
      return;
    }
    if (server.is_cancel_requested()) throw nav2_core::PlannerCancelled("Planner was cancelled");
    waitForCostmap([&server] { return server.is_server_active(); });
    if (server.is_preempt_requested()) goal = server.accept_pending_goal();
    result->path = plan(*goal);
    publishPlan(result->path);
    const rclcpp::Duration duration = now() - begin;
    result->planning_time = duration;
    if (max_planner_duration_ > 0 && duration.seconds() > max_planner_duration_) {
      RCLCPP_WARN(get_logger(),
                  "Planner loop missed its desired rate of %.4f Hz. Current loop rate is %.4f Hz",
                  1 / max_planner_duration_, 1 / duration.seconds());
    }
    server.succeeded_current(result);
  } catch (const nav2_core::PlannerCancelled&) {
    RCLCPP_INFO(get_logger(), "Goal was canceled. Canceling planning action.");
    server.terminate_all();
  } catch (const std::exception& error) {
    RCLCPP_WARN(get_logger(), "%s plugin failed to plan from (%.2f, %.2f) to (%0.2f, %.2f): \"%s\"",
                goal->planner_id.c_str(), last_start_.pose.position.x, last_start_.pose.position.y,
                last_goal_.pose.position.x, last_goal_.pose.position.y, error.what());
    result->error_code = code_of<typename ActionT::Result>(error);
    if constexpr (std::is_same_v<ActionT, ActionThroughPoses>) {
      if (is_without_viapoints(error)) result->error_code = ActionT::Result::NO_VIAPOINTS_GIVEN;
    }
    result->error_msg = error.what();
    server.terminate_current(result);
  }
}

void PlannerServer::computePlan() {
  Server<ActionToPose>& server = *action_server_pose_;
  answer(server, [this, &server](const ActionToPose::Goal& goal) {
    return planBetween(startOf(goal), goal.goal, goal.planner_id,
                       [&server] { return server.is_cancel_requested(); });
  });
}

void PlannerServer::computePlanThroughPoses() {
  Server<ActionThroughPoses>& server = *action_server_poses_;
  answer(server, [this, &server](const ActionThroughPoses::Goal& goal) {
    if (goal.goals.empty()) throw nav2_core::NoViapointsGiven("No viapoints given");
    Path whole;
    Pose start = startOf(goal);
    for (const Pose& next : goal.goals) {
      const Path part = planBetween(start, next, goal.planner_id,
                                    [&server] { return server.is_cancel_requested(); });
      // The goal of one part is the start of the next.
      const ptrdiff_t skipped = whole.poses.empty() ? 0 : 1;
      whole.poses.insert(whole.poses.end(), part.poses.begin() + skipped, part.poses.end());
      whole.header = part.header;
      start = part.poses.back();
      start.header = part.header;
    }
    return whole;
  });
}

nav_msgs::msg::Path PlannerServer::getPlan(const Pose& start, const Pose& goal,
                                           const std::string& planner_id,
                                           std::function<bool()> cancel_checker) {
  RCLCPP_DEBUG(get_logger(), "Attempting to a find path from (%.2f, %.2f) to (%.2f, %.2f).",
               start.pose.position.x, start.pose.position.y, goal.pose.position.x,
               goal.pose.position.y);
  const auto planner = planners_.find(planner_id);
  if (planner != planners_.end()) {
    return planner->second->createPlan(start, goal, cancel_checker);
  }
  if (planners_.size() == 1 && planner_id.empty()) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "No planners specified in action call. Server will use only plugin %s in "
                     "server. This warning will appear once.",
                     planner_ids_concat_.c_str());
    return planners_.begin()->second->createPlan(start, goal, cancel_checker);
  }
  RCLCPP_ERROR(get_logger(), "planner %s is not a valid planner. Planner names are: %s",
               planner_id.c_str(), planner_ids_concat_.c_str());
  throw nav2_core::InvalidPlanner("Planner id " + planner_id + " is invalid");
}

void PlannerServer::publishPlan(const nav_msgs::msg::Path& path) {
  if (plan_publisher_->is_activated() && plan_publisher_->get_subscription_count() > 0) {
    plan_publisher_->publish(std::make_unique<nav_msgs::msg::Path>(path));
  }
}

bool PlannerServer::isPoseFree(const geometry_msgs::msg::Pose& pose) const {
  if (!collision_checker_) {
    unsigned int mx;
    unsigned int my;
    if (!costmap_->worldToMap(pose.position.x, pose.position.y, mx, my)) return false;
    const unsigned char cost = costmap_->getCost(mx, my);
    return cost != nav2_costmap_2d::LETHAL_OBSTACLE &&
           cost != nav2_costmap_2d::INSCRIBED_INFLATED_OBSTACLE;
  }
  const double cost = collision_checker_->footprintCostAtPose(pose.position.x, pose.position.y,
                                                              tf2::getYaw(pose.orientation),
                                                              costmap_ros_->getRobotFootprint());
  return cost != nav2_costmap_2d::LETHAL_OBSTACLE;
}

void PlannerServer::isPathValid(const std::shared_ptr<nav2_msgs::srv::IsPathValid::Request> request,
                                std::shared_ptr<nav2_msgs::srv::IsPathValid::Response> response) {
  const auto& poses = request->path.poses;
  response->is_valid = !poses.empty();
  Pose robot;
  if (poses.empty() || !costmap_ros_->getRobotPose(robot)) return;
  // Poses behind the robot do not count: something may stand there by now.
  const auto distance_of = [&robot](const Pose& pose) {
    return nav2_util::geometry_utils::euclidean_distance(robot.pose, pose.pose);
  };
  const auto nearest = std::min_element(
      poses.begin(), poses.end(),
      [&](const Pose& a, const Pose& b) { return distance_of(a) < distance_of(b); });
  const std::unique_lock<nav2_costmap_2d::Costmap2D::mutex_t> lock(*costmap_->getMutex());
  response->is_valid =
      std::all_of(nearest, poses.end(), [this](const Pose& pose) { return isPoseFree(pose.pose); });
}

}  // namespace nav2_planner
