// See back_up.hpp.
#include "nav2_behaviors/plugins/back_up.hpp"

#include "pluginlib/class_list_macros.hpp"

namespace nav2_behaviors {

ResultStatus BackUp::onRun(const std::shared_ptr<const BackUpActionGoal> command) {
  if (command->target.y != 0.0 || command->target.z != 0.0) {
    RCLCPP_INFO(logger_, "Backing up in Y and Z not supported, will only move in X.");
    return {Status::FAILED, BackUpActionResult::INVALID_INPUT};
  }
  return begin(-std::abs(command->target.x), -std::abs(command->speed), command->time_allowance);
}

}  // namespace nav2_behaviors

PLUGINLIB_EXPORT_CLASS(nav2_behaviors::BackUp, nav2_core::Behavior)
