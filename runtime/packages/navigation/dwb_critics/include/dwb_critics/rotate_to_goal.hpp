// Once the robot is at the goal, it has to stop, and then to turn only.
#pragma once

#include "dwb_core/trajectory_critic.hpp"

namespace dwb_critics {

class RotateToGoalCritic : public dwb_core::TrajectoryCritic {
 public:
  void onInit() override;
  void reset() override;
  bool prepare(const geometry_msgs::msg::Pose2D& pose, const nav_2d_msgs::msg::Twist2D& vel,
               const geometry_msgs::msg::Pose2D& goal,
               const nav_2d_msgs::msg::Path2D& global_plan) override;
  double scoreTrajectory(const dwb_msgs::msg::Trajectory2D& traj) override;
  /// The angle [rad] from the direction of the goal.
  virtual double scoreRotation(const dwb_msgs::msg::Trajectory2D& traj);

 private:
  bool in_window_ = false;  // has been at the goal since the path came
  bool rotating_ = false;   // has stopped there
  double goal_yaw_ = 0.0;
  double xy_goal_tolerance_ = 0.25;       // m
  double trans_stopped_velocity_ = 0.25;  // m/s
  double current_xy_speed_sq_ = 0.0;
  double slowing_factor_ = 5.0;
  double lookahead_time_ = -1.0;  // s; below 0: the end of the trajectory
};

}  // namespace dwb_critics
