// See oscillation.hpp.
#include "dwb_critics/oscillation.hpp"

#include <cmath>

#include "angles/angles.h"
#include "dwb_core/exceptions.hpp"
#include "nav_2d_utils/parameters.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace dwb_critics {

void OscillationCritic::onInit() {
  const auto node = node_.lock();
  const std::string prefix = dwb_plugin_name_ + "." + name_ + ".";
  const auto read = [&](const char* name, double& value) {
    value = nav_2d_utils::searchAndGetParam(node, prefix + name, value);
  };
  read("oscillation_reset_dist", oscillation_reset_dist_);
  read("oscillation_reset_angle", oscillation_reset_angle_);
  read("oscillation_reset_time", oscillation_reset_time_);
  read("x_only_threshold", x_only_threshold_);
  clock_ = node->get_clock();
  prev_reset_time_ = clock_->now();
  reset();
}

bool OscillationCritic::prepare(const geometry_msgs::msg::Pose2D& pose,
                                const nav_2d_msgs::msg::Twist2D&, const geometry_msgs::msg::Pose2D&,
                                const nav_2d_msgs::msg::Path2D&) {
  pose_ = pose;
  return true;
}

void OscillationCritic::debrief(const nav_2d_msgs::msg::Twist2D& cmd_vel) {
  if (setOscillationFlags(cmd_vel)) {
    prev_stationary_pose_ = pose_;
    prev_reset_time_ = clock_->now();
  }
  const bool has_flipped =
      x_trend_.hasSignFlipped() || y_trend_.hasSignFlipped() || theta_trend_.hasSignFlipped();
  if (has_flipped && resetAvailable()) reset();
}

bool OscillationCritic::resetAvailable() {
  const double distance =
      std::hypot(pose_.x - prev_stationary_pose_.x, pose_.y - prev_stationary_pose_.y);
  const double angle =
      std::abs(angles::shortest_angular_distance(prev_stationary_pose_.theta, pose_.theta));
  const double seconds = (clock_->now() - prev_reset_time_).seconds();
  const auto is_above = [](double value, double limit) { return limit >= 0.0 && value > limit; };
  return is_above(distance, oscillation_reset_dist_) || is_above(angle, oscillation_reset_angle_) ||
         is_above(seconds, oscillation_reset_time_);
}

void OscillationCritic::reset() {
  x_trend_.reset();
  y_trend_.reset();
  theta_trend_.reset();
}

bool OscillationCritic::setOscillationFlags(const nav_2d_msgs::msg::Twist2D& cmd_vel) {
  bool has_flipped = x_trend_.update(cmd_vel.x);
  if (x_only_threshold_ >= 0.0 && std::abs(cmd_vel.x) > x_only_threshold_) return has_flipped;
  has_flipped |= y_trend_.update(cmd_vel.y);
  has_flipped |= theta_trend_.update(cmd_vel.theta);
  return has_flipped;
}

double OscillationCritic::scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) {
  if (x_trend_.isOscillating(traj.velocity.x) || y_trend_.isOscillating(traj.velocity.y) ||
      theta_trend_.isOscillating(traj.velocity.theta)) {
    throw dwb_core::IllegalTrajectoryException(name_, "Trajectory is oscillating.");
  }
  return 0.0;
}

}  // namespace dwb_critics

PLUGINLIB_EXPORT_CLASS(dwb_critics::OscillationCritic, dwb_core::TrajectoryCritic)
