// See wait.hpp.
#include "nav2_behaviors/plugins/wait.hpp"

#include "pluginlib/class_list_macros.hpp"

namespace nav2_behaviors {

Wait::Wait() : feedback_(std::make_shared<WaitAction::Feedback>()) {}

Wait::~Wait() = default;

ResultStatus Wait::onRun(const std::shared_ptr<const WaitActionGoal> command) {
  wait_end_ = clock_->now() + rclcpp::Duration(command->time);
  return ResultStatus{Status::SUCCEEDED};
}

ResultStatus Wait::onCycleUpdate() {
  const rclcpp::Duration left = wait_end_ - clock_->now();
  feedback_->time_left = left;
  action_server_->publish_feedback(feedback_);
  return ResultStatus{left.nanoseconds() > 0 ? Status::RUNNING : Status::SUCCEEDED};
}

}  // namespace nav2_behaviors

PLUGINLIB_EXPORT_CLASS(nav2_behaviors::Wait, nav2_core::Behavior)
