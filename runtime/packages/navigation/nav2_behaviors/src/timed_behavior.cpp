// See timed_behavior.hpp.
#include "nav2_behaviors/timed_behavior.hpp"

namespace nav2_behaviors {

nav2_util::LifecycleNode::SharedPtr BehaviorParts::setUp(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent, const std::string& name,
    std::shared_ptr<tf2_ros::Buffer> tf,
    std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> local_collision_checker,
    std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> global_collision_checker) {
  node_ = parent;
  const auto node = std::static_pointer_cast<nav2_util::LifecycleNode>(parent.lock());
  logger_ = node->get_logger();
  clock_ = node->get_clock();
  RCLCPP_INFO(logger_, "Configuring %s", name.c_str());
  behavior_name_ = name;
  tf_ = std::move(tf);
  local_collision_checker_ = std::move(local_collision_checker);
  global_collision_checker_ = std::move(global_collision_checker);
  node->get_parameter("cycle_frequency", cycle_frequency_);
  node->get_parameter("local_frame", local_frame_);
  node->get_parameter("global_frame", global_frame_);
  node->get_parameter("robot_base_frame", robot_base_frame_);
  node->get_parameter("transform_tolerance", transform_tolerance_);
  nav2_util::declare_parameter_if_not_declared(node, "action_server_result_timeout",
                                               rclcpp::ParameterValue(10.0));
  server_options_.result_timeout.nanoseconds =
      RCL_S_TO_NS(node->get_parameter("action_server_result_timeout").as_double());
  vel_pub_ = std::make_unique<nav2_util::TwistPublisher>(node, "cmd_vel", 1);
  return node;
}

bool BehaviorParts::isReady() const {
  RCLCPP_INFO(logger_, "Running %s", behavior_name_.c_str());
  if (!enabled_) RCLCPP_WARN(logger_, "Called while inactive, ignoring request.");
  return enabled_;
}

void BehaviorParts::logInterruption(Interruption why) const {
  const char* name = behavior_name_.c_str();
  switch (why) {
    case Interruption::NONE:
      break;
    case Interruption::INACTIVE:
      RCLCPP_DEBUG(logger_, "Action server unavailable or inactive. Stopping.");
      break;
    case Interruption::PREEMPTED:
      RCLCPP_ERROR(logger_,
                   "Received a preemption request for %s, however feature is currently not "
                   "implemented. Aborting and stopping.",
                   name);
      break;
    case Interruption::CANCELED:
      RCLCPP_INFO(logger_, "Canceling %s", name);
      break;
  }
}

void BehaviorParts::logEnd(bool succeeded) const {
  if (succeeded) {
    RCLCPP_INFO(logger_, "%s completed successfully", behavior_name_.c_str());
  } else {
    RCLCPP_WARN(logger_, "%s failed", behavior_name_.c_str());
  }
}

void BehaviorParts::setEnabled(bool enabled) {
  if (enabled) RCLCPP_INFO(logger_, "Activating %s", behavior_name_.c_str());
  enabled ? vel_pub_->on_activate() : vel_pub_->on_deactivate();
  enabled_ = enabled;
}

void BehaviorParts::stopRobot() {
  auto velocity = std::make_unique<geometry_msgs::msg::TwistStamped>();
  velocity->header.frame_id = robot_base_frame_;
  velocity->header.stamp = clock_->now();
  vel_pub_->publish(std::move(velocity));
}

}  // namespace nav2_behaviors
