// See rotate_to_goal.hpp.
#include "dwb_critics/rotate_to_goal.hpp"

#include <cmath>

#include "angles/angles.h"
#include "dwb_core/exceptions.hpp"
#include "dwb_core/trajectory_utils.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

using dwb_core::IllegalTrajectoryException;

namespace {

double squared(double x, double y) {
  return x * x + y * y;
}

}  // namespace

void RotateToGoalCritic::onInit() {
  const auto node = node_.lock();
  const auto read = [&](const std::string& name, double& value) {
    value = nav_2d_utils::searchAndGetParam(node, dwb_plugin_name_ + "." + name, value);
  };
  read("xy_goal_tolerance", xy_goal_tolerance_);
  read("trans_stopped_velocity", trans_stopped_velocity_);
  read(name_ + ".slowing_factor", slowing_factor_);
  read(name_ + ".lookahead_time", lookahead_time_);
  reset();
}

void RotateToGoalCritic::reset() {
  in_window_ = false;
  rotating_ = false;
}

bool RotateToGoalCritic::prepare(const geometry_msgs::msg::Pose2D& pose,
                                 const nav_2d_msgs::msg::Twist2D& vel,
                                 const geometry_msgs::msg::Pose2D& goal,
                                 const nav_2d_msgs::msg::Path2D&) {
  current_xy_speed_sq_ = squared(vel.x, vel.y);
  in_window_ = in_window_ ||
               squared(pose.x - goal.x, pose.y - goal.y) <= xy_goal_tolerance_ * xy_goal_tolerance_;
  rotating_ = rotating_ || (in_window_ && current_xy_speed_sq_ <=
                                              trans_stopped_velocity_ * trans_stopped_velocity_);
  goal_yaw_ = goal.theta;
  return true;
}

double RotateToGoalCritic::scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) {
  if (!in_window_) return 0.0;
  const double speed_sq = squared(traj.velocity.x, traj.velocity.y);
  if (rotating_) {
    if (speed_sq > 0) throw IllegalTrajectoryException(name_, "Nonrotation command near goal.");
    return scoreRotation(traj);
  }
  if (speed_sq >= current_xy_speed_sq_) {
    throw IllegalTrajectoryException(name_, "Not slowing down near goal.");
  }
  return speed_sq * slowing_factor_ + scoreRotation(traj);
}

double RotateToGoalCritic::scoreRotation(const dwb_msgs::msg::Trajectory2D& traj) {
  if (traj.poses.empty()) throw IllegalTrajectoryException(name_, "Empty trajectory.");
  const double end_yaw = lookahead_time_ >= 0.0 ? dwb_core::projectPose(traj, lookahead_time_).theta
                                                : traj.poses.back().theta;
  return std::abs(angles::shortest_angular_distance(end_yaw, goal_yaw_));
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::RotateToGoalCritic, dwb_core::TrajectoryCritic)
