// See assisted_teleop.hpp.
#include "nav2_behaviors/plugins/assisted_teleop.hpp"

#include "nav_2d_utils/conversions.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_behaviors {

using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;

namespace {

/// Bounds what one cycle can cost.
constexpr double kMostSteps = 10'000;

}  // namespace

AssistedTeleop::AssistedTeleop() : feedback_(std::make_shared<AssistedTeleopAction::Feedback>()) {}

void AssistedTeleop::onConfigure() {
  const auto node = std::static_pointer_cast<nav2_util::LifecycleNode>(node_.lock());
  const auto declare = [&node](const char* name, const rclcpp::ParameterValue& value) {
    nav2_util::declare_parameter_if_not_declared(node, name, value);
  };
  declare("projection_time", rclcpp::ParameterValue(1.0));
  declare("simulation_time_step", rclcpp::ParameterValue(0.1));
  declare("cmd_vel_teleop", rclcpp::ParameterValue("cmd_vel_teleop"));
  node->get_parameter("projection_time", projection_time_);
  node->get_parameter("simulation_time_step", simulation_time_step_);
  if (!(simulation_time_step_ > 0)) {
    throw std::invalid_argument("simulation_time_step must be greater than 0");
  }
  if (!(projection_time_ / simulation_time_step_ <= kMostSteps)) {
    throw std::invalid_argument(
        "projection_time must be at most 10,000 times simulation_time_step");
  }
  vel_sub_ = std::make_unique<nav2_util::TwistSubscriber>(
      node, node->get_parameter("cmd_vel_teleop").as_string(), rclcpp::SystemDefaultsQoS(),
      [this](Twist::SharedPtr message) {
        TwistStamped twist;
        twist.twist = *message;
        setTwist(twist);
      },
      [this](TwistStamped::SharedPtr message) { setTwist(*message); });
  preempt_teleop_sub_ = node->create_subscription<std_msgs::msg::Empty>(
      "preempt_teleop", rclcpp::SystemDefaultsQoS(),
      [this](std_msgs::msg::Empty::SharedPtr message) { preemptTeleopCallback(message); });
}

void AssistedTeleop::onCleanup() {
  vel_sub_.reset();
  preempt_teleop_sub_.reset();
}

void AssistedTeleop::setTwist(const TwistStamped& twist) {
  // A velocity from before a goal must not move the robot once the goal is accepted.
  if (!action_server_->is_running()) return;
  if (!nav2_util::validateTwist(twist)) {
    RCLCPP_ERROR(logger_, "A velocity that is not finite is ignored.");
    return;
  }
  const std::lock_guard<std::mutex> lock(twist_mutex_);
  teleop_twist_ = twist;
}

ResultStatus AssistedTeleop::onRun(const std::shared_ptr<const AssistedTeleopActionGoal> command) {
  preempt_teleop_ = false;
  command_time_allowance_ = command->time_allowance;
  end_time_ = clock_->now() + command_time_allowance_;
  return {Status::SUCCEEDED, AssistedTeleopActionResult::NONE};
}

void AssistedTeleop::onActionCompletion(std::shared_ptr<AssistedTeleopActionResult>) {
  {
    const std::lock_guard<std::mutex> lock(twist_mutex_);
    teleop_twist_ = TwistStamped();
  }
  preempt_teleop_ = false;
}

ResultStatus AssistedTeleop::onCycleUpdate() {
  feedback_->current_teleop_duration = elasped_time_;
  action_server_->publish_feedback(feedback_);
  const char* name = behavior_name_.c_str();
  if (command_time_allowance_.nanoseconds() > 0 && clock_->now() > end_time_) {
    stopRobot();
    RCLCPP_WARN(logger_, "Exceeded time allowance before reaching the %sgoal - Exiting %s", name,
                name);
    return {Status::FAILED, AssistedTeleopActionResult::TIMEOUT};
  }
  if (preempt_teleop_) {
    stopRobot();
    return {Status::SUCCEEDED, AssistedTeleopActionResult::NONE};
  }
  geometry_msgs::msg::PoseStamped pose;
  if (!nav2_util::getCurrentPose(pose, *tf_, local_frame_, robot_base_frame_,
                                 transform_tolerance_)) {
    stopRobot();
    RCLCPP_ERROR(logger_, "Current robot pose is not available for %s", name);
    return {Status::FAILED, AssistedTeleopActionResult::TF_ERROR};
  }
  auto velocity = std::make_unique<TwistStamped>();
  {
    const std::lock_guard<std::mutex> lock(twist_mutex_);
    *velocity = teleop_twist_;
  }
  const double part = freePart(nav_2d_utils::poseToPose2D(pose.pose), velocity->twist);
  velocity->twist.linear.x *= part;
  velocity->twist.linear.y *= part;
  velocity->twist.angular.z *= part;
  vel_pub_->publish(std::move(velocity));
  return {Status::RUNNING, AssistedTeleopActionResult::NONE};
}

double AssistedTeleop::freePart(geometry_msgs::msg::Pose2D pose, const Twist& twist) {
  const char* name = behavior_name_.c_str();
  bool is_first = true;
  for (double time = simulation_time_step_; time < projection_time_;
       time += simulation_time_step_) {
    pose = projectPose(pose, twist, simulation_time_step_);
    // The costmap is read once for all of them.
    if (local_collision_checker_->isCollisionFree(pose, is_first)) {
      is_first = false;
      continue;
    }
    if (is_first) {
      RCLCPP_DEBUG_THROTTLE(logger_, *clock_, 1000,
                            "%s collided on first time step, setting velocity to zero", name);
      return 0.0;
    }
    RCLCPP_DEBUG_THROTTLE(logger_, *clock_, 1000, "%s collision approaching in %g seconds", name,
                          time);
    return time / projection_time_;
  }
  return 1.0;
}

geometry_msgs::msg::Pose2D AssistedTeleop::projectPose(const geometry_msgs::msg::Pose2D& pose,
                                                       const Twist& twist, double projection_time) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  geometry_msgs::msg::Pose2D projected = pose;
  projected.x += projection_time * (twist.linear.x * c - twist.linear.y * s);
  projected.y += projection_time * (twist.linear.x * s + twist.linear.y * c);
  projected.theta += projection_time * twist.angular.z;
  return projected;
}

void AssistedTeleop::preemptTeleopCallback(const std_msgs::msg::Empty::SharedPtr) {
  preempt_teleop_ = true;
}

}  // namespace nav2_behaviors

PLUGINLIB_EXPORT_CLASS(nav2_behaviors::AssistedTeleop, nav2_core::Behavior)
