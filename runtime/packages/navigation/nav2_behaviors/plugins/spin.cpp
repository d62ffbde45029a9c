// See spin.hpp.
#include "nav2_behaviors/plugins/spin.hpp"

#include <algorithm>

#include "nav_2d_utils/conversions.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_behaviors {

Spin::Spin() : feedback_(std::make_shared<SpinAction::Feedback>()) {}

Spin::~Spin() = default;

void Spin::onConfigure() {
  const auto node = node_.lock();
  const auto read = [&node](const char* name, double default_value, double& value) {
    nav2_util::declare_parameter_if_not_declared(node, name, rclcpp::ParameterValue(default_value));
    node->get_parameter(name, value);
  };
  read("simulate_ahead_time", 2.0, simulate_ahead_time_);
  read("max_rotational_vel", 1.0, max_rotational_vel_);
  read("min_rotational_vel", 0.4, min_rotational_vel_);
  read("rotational_acc_lim", 3.2, rotational_acc_lim_);
}

ResultStatus Spin::onRun(const std::shared_ptr<const SpinActionGoal> command) {
  if (!std::isfinite(command->target_yaw)) {
    RCLCPP_ERROR(logger_, "target_yaw is not a finite number.");
    return {Status::FAILED, SpinActionResult::UNKNOWN};
  }
  geometry_msgs::msg::PoseStamped pose;
  if (!nav2_util::getCurrentPose(pose, *tf_, local_frame_, robot_base_frame_,
                                 transform_tolerance_)) {
    RCLCPP_ERROR(logger_, "Current robot pose is not available.");
    return {Status::FAILED, SpinActionResult::TF_ERROR};
  }
  prev_yaw_ = tf2::getYaw(pose.pose.orientation);
  relative_yaw_ = 0.0;
  cmd_yaw_ = command->target_yaw;
  RCLCPP_INFO(logger_, "Turning %0.2f for spin behavior.", cmd_yaw_);
  command_time_allowance_ = command->time_allowance;
  end_time_ = clock_->now() + command_time_allowance_;
  return {Status::SUCCEEDED, SpinActionResult::NONE};
}

ResultStatus Spin::onCycleUpdate() {
  if (command_time_allowance_.nanoseconds() > 0 && clock_->now() > end_time_) {
    stopRobot();
    RCLCPP_WARN(logger_, "Exceeded time allowance before reaching the Spin goal - Exiting Spin");
    return {Status::FAILED, SpinActionResult::TIMEOUT};
  }
  geometry_msgs::msg::PoseStamped pose;
  if (!nav2_util::getCurrentPose(pose, *tf_, local_frame_, robot_base_frame_,
                                 transform_tolerance_)) {
    stopRobot();
    RCLCPP_ERROR(logger_, "Current robot pose is not available.");
    return {Status::FAILED, SpinActionResult::TF_ERROR};
  }
  geometry_msgs::msg::Pose2D planar = nav_2d_utils::poseToPose2D(pose.pose);
  addTurn(planar.theta);
  feedback_->angular_distance_traveled = static_cast<float>(relative_yaw_);
  action_server_->publish_feedback(feedback_);
  const double remaining = std::abs(cmd_yaw_) - std::abs(relative_yaw_);
  if (remaining < 1e-6) {
    stopRobot();
    return {Status::SUCCEEDED, SpinActionResult::NONE};
  }
  // The speed that the robot can still brake from.
  const double braking = std::sqrt(2 * rotational_acc_lim_ * remaining);
  auto velocity = std::make_unique<geometry_msgs::msg::TwistStamped>();
  velocity->header.frame_id = robot_base_frame_;
  velocity->header.stamp = clock_->now();
  velocity->twist.angular.z = std::copysign(
      std::min(std::max(braking, min_rotational_vel_), max_rotational_vel_), cmd_yaw_);
  if (!isCollisionFree(relative_yaw_, velocity->twist, planar)) {
    stopRobot();
    RCLCPP_WARN(logger_, "Collision Ahead - Exiting Spin");
    return {Status::FAILED, SpinActionResult::COLLISION_AHEAD};
  }
  vel_pub_->publish(std::move(velocity));
  return {Status::RUNNING, SpinActionResult::NONE};
}

void Spin::addTurn(double yaw) {
  relative_yaw_ += std::remainder(yaw - prev_yaw_, 2 * M_PI);
  prev_yaw_ = yaw;
}

bool Spin::isCollisionFree(const double& relative_yaw, const geometry_msgs::msg::Twist& cmd_vel,
                           geometry_msgs::msg::Pose2D& pose2d) {
  const double yaw = pose2d.theta;
  const double cycles = std::floor(cycle_frequency_ * simulate_ahead_time_);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double turn = cmd_vel.angular.z * cycle / cycle_frequency_;
    if (std::abs(turn) >= std::abs(relative_yaw)) break;
    pose2d.theta = yaw + turn;
    // The costmap is read once for all of them.
    if (!local_collision_checker_->isCollisionFree(pose2d, cycle == 0)) return false;
  }
  return true;
}

}  // namespace nav2_behaviors

PLUGINLIB_EXPORT_CLASS(nav2_behaviors::Spin, nav2_core::Behavior)
