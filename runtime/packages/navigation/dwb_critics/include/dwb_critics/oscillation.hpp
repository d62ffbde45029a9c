// Forbids commands that go back and forth at one place.
#pragma once

#include "dwb_core/trajectory_critic.hpp"
#include "dwb_critics/command_trend.hpp"

namespace dwb_critics {

class OscillationCritic : public dwb_core::TrajectoryCritic {
 public:
  void onInit() override;
  bool prepare(const geometry_msgs::msg::Pose2D& pose, const nav_2d_msgs::msg::Twist2D& vel,
               const geometry_msgs::msg::Pose2D& goal,
               const nav_2d_msgs::msg::Path2D& global_plan) override;
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override;
  void reset() override;
  void debrief(const nav_2d_msgs::msg::Twist2D& cmd_vel) override;

 private:
  bool setOscillationFlags(const nav_2d_msgs::msg::Twist2D& cmd_vel);
  /// Whether the robot has moved, or enough time has passed, since a sign changed.
  bool resetAvailable();

  CommandTrend x_trend_;
  CommandTrend y_trend_;
  CommandTrend theta_trend_;
  // A value below 0 does not count.
  double oscillation_reset_dist_ = 0.05;  // m
  double oscillation_reset_angle_ = 0.2;  // rad
  double oscillation_reset_time_ = -1.0;  // s
  double x_only_threshold_ = 0.05;        // m/s: above it, only x has a trend
  geometry_msgs::msg::Pose2D pose_;
  geometry_msgs::msg::Pose2D prev_stationary_pose_;
  rclcpp::Time prev_reset_time_;
  rclcpp::Clock::SharedPtr clock_;
};

}  // namespace dwb_critics
