// Drives straight on by a distance, at a constant speed.
#pragma once

#include <memory>
#include <utility>

#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_behaviors/timed_behavior.hpp"
#include "nav2_msgs/action/back_up.hpp"
#include "nav2_msgs/action/drive_on_heading.hpp"
#include "nav_2d_utils/conversions.hpp"

namespace nav2_behaviors {

template <typename ActionT = nav2_msgs::action::DriveOnHeading>
class DriveOnHeading : public TimedBehavior<ActionT> {
  using CostmapInfoType = nav2_core::CostmapInfoType;

 public:
  DriveOnHeading() : feedback_(std::make_shared<typename ActionT::Feedback>()) {}
  ~DriveOnHeading() = default;

  ResultStatus onRun(const std::shared_ptr<const typename ActionT::Goal> command) override {
    if (command->target.y != 0.0 || command->target.z != 0.0) {
      RCLCPP_INFO(this->logger_, "DrivingOnHeading in Y and Z not supported, will only move in X.");
      return {Status::FAILED, ActionT::Result::INVALID_INPUT};
    }
    if ((command->target.x > 0.0) != (command->speed > 0.0)) {
      RCLCPP_ERROR(this->logger_, "Speed and command sign did not match");
      return {Status::FAILED, ActionT::Result::INVALID_INPUT};
    }
    return begin(command->target.x, command->speed, command->time_allowance);
  }

  ResultStatus onCycleUpdate() override {
    if (command_time_allowance_.nanoseconds() > 0 && this->clock_->now() > end_time_) {
      this->stopRobot();
      RCLCPP_WARN(this->logger_,
                  "Exceeded time allowance before reaching the DriveOnHeading goal - Exiting "
                  "DriveOnHeading");
      return {Status::FAILED, ActionT::Result::TIMEOUT};
    }
    geometry_msgs::msg::PoseStamped pose;
    if (!getPose(pose)) {
      this->stopRobot();
      RCLCPP_ERROR(this->logger_, "Current robot pose is not available.");
      return {Status::FAILED, ActionT::Result::TF_ERROR};
    }
    const double distance = std::hypot(initial_pose_.pose.position.x - pose.pose.position.x,
                                       initial_pose_.pose.position.y - pose.pose.position.y);
    feedback_->distance_traveled = static_cast<float>(distance);
    this->action_server_->publish_feedback(feedback_);
    if (distance >= std::abs(command_x_)) {
      this->stopRobot();
      return {Status::SUCCEEDED, ActionT::Result::NONE};
    }
    auto velocity = std::make_unique<geometry_msgs::msg::TwistStamped>();
    velocity->header.stamp = this->clock_->now();
    velocity->header.frame_id = this->robot_base_frame_;
    velocity->twist.linear.x = command_speed_;
    geometry_msgs::msg::Pose2D planar = nav_2d_utils::poseToPose2D(pose.pose);
    if (!isCollisionFree(distance, velocity->twist, planar)) {
      this->stopRobot();
      RCLCPP_WARN(this->logger_, "Collision Ahead - Exiting DriveOnHeading");
      return {Status::FAILED, ActionT::Result::COLLISION_AHEAD};
    }
    this->vel_pub_->publish(std::move(velocity));
    return {Status::RUNNING, ActionT::Result::NONE};
  }

  CostmapInfoType getResourceInfo() override { return CostmapInfoType::LOCAL; }

 protected:
  /// Takes a goal that is checked but for its numbers and the robot's pose.
  ResultStatus begin(double x, double speed, const rclcpp::Duration& allowance) {
    if (!std::isfinite(x) || !std::isfinite(speed)) {
      RCLCPP_ERROR(this->logger_, "The target or the speed is not a finite number.");
      return {Status::FAILED, ActionT::Result::INVALID_INPUT};
    }
    command_x_ = x;
    command_speed_ = speed;
    command_time_allowance_ = allowance;
    end_time_ = this->clock_->now() + command_time_allowance_;
    if (!getPose(initial_pose_)) {
      RCLCPP_ERROR(this->logger_, "Initial robot pose is not available.");
      return {Status::FAILED, ActionT::Result::TF_ERROR};
    }
    return {Status::SUCCEEDED, ActionT::Result::NONE};
  }

  /// Looks ahead by `simulate_ahead_time`, at most to the end of the way. Changes `pose2d`.
  bool isCollisionFree(const double& distance, const geometry_msgs::msg::Twist& cmd_vel,
                       geometry_msgs::msg::Pose2D& pose2d) {
    const geometry_msgs::msg::Pose2D start = pose2d;
    const double remaining = std::abs(command_x_) - distance;
    const double cycles = std::floor(this->cycle_frequency_ * simulate_ahead_time_);
    for (int cycle = 0; cycle < cycles; ++cycle) {
      const double way = cmd_vel.linear.x * cycle / this->cycle_frequency_;
      if (std::abs(way) >= remaining) break;
      pose2d.x = start.x + way * std::cos(start.theta);
      pose2d.y = start.y + way * std::sin(start.theta);
      // The costmap is read once for all of them.
      if (!this->local_collision_checker_->isCollisionFree(pose2d, cycle == 0)) return false;
    }
    return true;
  }

  void onConfigure() override {
    const auto node = this->node_.lock();
    nav2_util::declare_parameter_if_not_declared(node, "simulate_ahead_time",
                                                 rclcpp::ParameterValue(2.0));
    node->get_parameter("simulate_ahead_time", simulate_ahead_time_);
  }

  typename ActionT::Feedback::SharedPtr feedback_;
  geometry_msgs::msg::PoseStamped initial_pose_;
  double command_x_ = 0.0;      // m
  double command_speed_ = 0.0;  // m/s
  rclcpp::Duration command_time_allowance_{0, 0};
  rclcpp::Time end_time_;
  double simulate_ahead_time_ = 0.0;  // s

 private:
  bool getPose(geometry_msgs::msg::PoseStamped& pose) {
    return nav2_util::getCurrentPose(pose, *this->tf_, this->local_frame_, this->robot_base_frame_,
                                     this->transform_tolerance_);
  }
};

}  // namespace nav2_behaviors
