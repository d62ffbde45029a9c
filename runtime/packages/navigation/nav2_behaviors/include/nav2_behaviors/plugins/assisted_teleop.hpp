// A person steers: velocities are passed on, and scaled down before an obstacle.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>

#include "geometry_msgs/msg/twist.hpp"
#include "nav2_behaviors/timed_behavior.hpp"
#include "nav2_msgs/action/assisted_teleop.hpp"
#include "nav2_util/twist_subscriber.hpp"
#include "std_msgs/msg/empty.hpp"

namespace nav2_behaviors {

using AssistedTeleopAction = nav2_msgs::action::AssistedTeleop;

class AssistedTeleop : public TimedBehavior<AssistedTeleopAction> {
  using CostmapInfoType = nav2_core::CostmapInfoType;

 public:
  using AssistedTeleopActionGoal = AssistedTeleopAction::Goal;
  using AssistedTeleopActionResult = AssistedTeleopAction::Result;

  AssistedTeleop();

  ResultStatus onRun(const std::shared_ptr<const AssistedTeleopActionGoal> command) override;
  void onActionCompletion(std::shared_ptr<AssistedTeleopActionResult> /*result*/) override;
  ResultStatus onCycleUpdate() override;
  CostmapInfoType getResourceInfo() override { return CostmapInfoType::LOCAL; }

 protected:
  void onConfigure() override;
  void onCleanup() override;
  /// The pose after a time, in seconds, at a constant velocity.
  geometry_msgs::msg::Pose2D projectPose(const geometry_msgs::msg::Pose2D& pose,
                                         const geometry_msgs::msg::Twist& twist,
                                         double projection_time);
  /// The person is done: the goal succeeds.
  void preemptTeleopCallback(const std_msgs::msg::Empty::SharedPtr msg);

  AssistedTeleopAction::Feedback::SharedPtr feedback_;
  double projection_time_ = 0.0;       // s
  double simulation_time_step_ = 0.0;  // s
  geometry_msgs::msg::TwistStamped teleop_twist_;
  std::atomic<bool> preempt_teleop_{false};
  std::unique_ptr<nav2_util::TwistSubscriber> vel_sub_;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr preempt_teleop_sub_;
  rclcpp::Duration command_time_allowance_{0, 0};
  rclcpp::Time end_time_;

 private:
  void setTwist(const geometry_msgs::msg::TwistStamped& twist);
  /// The part of the velocity, 0 to 1, at which the way ahead is free.
  double freePart(geometry_msgs::msg::Pose2D pose, const geometry_msgs::msg::Twist& twist);

  std::mutex twist_mutex_;  // of teleop_twist_: messages come while a goal runs
};

}  // namespace nav2_behaviors
