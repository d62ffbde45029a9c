// Turns on the spot by an angle, as fast as the limits allow, and slower before its end.
#pragma once

#include <memory>

#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_behaviors/timed_behavior.hpp"
#include "nav2_msgs/action/spin.hpp"

namespace nav2_behaviors {

using SpinAction = nav2_msgs::action::Spin;

class Spin : public TimedBehavior<SpinAction> {
  using CostmapInfoType = nav2_core::CostmapInfoType;

 public:
  using SpinActionGoal = SpinAction::Goal;
  using SpinActionResult = SpinAction::Result;

  Spin();
  ~Spin();

  ResultStatus onRun(const std::shared_ptr<const SpinActionGoal> command) override;
  void onConfigure() override;
  ResultStatus onCycleUpdate() override;
  CostmapInfoType getResourceInfo() override { return CostmapInfoType::LOCAL; }

 protected:
  /// Looks ahead by as much as the robot has turned, at most `simulate_ahead_time`: a robot that
  /// stands close to an obstacle may begin. Changes `pose2d`.
  bool isCollisionFree(const double& relative_yaw, const geometry_msgs::msg::Twist& cmd_vel,
                       geometry_msgs::msg::Pose2D& pose2d);

  SpinAction::Feedback::SharedPtr feedback_;
  double min_rotational_vel_ = 0.0;   // rad/s
  double max_rotational_vel_ = 0.0;   // rad/s
  double rotational_acc_lim_ = 0.0;   // rad/s^2
  double cmd_yaw_ = 0.0;              // rad, of the goal
  double prev_yaw_ = 0.0;             // rad, of the last cycle
  double relative_yaw_ = 0.0;         // rad, since the beginning
  double simulate_ahead_time_ = 0.0;  // s
  rclcpp::Duration command_time_allowance_{0, 0};
  rclcpp::Time end_time_;

 private:
  void addTurn(double yaw);
};

}  // namespace nav2_behaviors
