// See navigate_through_poses.hpp.
#include "nav2_bt_navigator/navigators/navigate_through_poses.hpp"

#include <stdexcept>
#include <utility>

#include "navigators/progress.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_bt_navigator {

bool NavigateThroughPosesNavigator::configure(
    rclcpp_lifecycle::LifecycleNode::WeakPtr parent_node,
    std::shared_ptr<nav2_util::OdomSmoother> odom_smoother) {
  const auto node = parent_node.lock();
  goals_blackboard_id_ = parameter(*node, "goals_blackboard_id", std::string("goals"));
  path_blackboard_id_ = parameter(*node, "path_blackboard_id", std::string("path"));
  odom_smoother_ = odom_smoother;
  set_groot(*node, getName(), 1669, *bt_action_server_);
  return true;
}

std::string NavigateThroughPosesNavigator::getDefaultBTFilepath(
    rclcpp_lifecycle::LifecycleNode::WeakPtr node) {
  return tree_file(*node.lock(), "default_nav_through_poses_bt_xml",
                   "navigate_through_poses_w_replanning_and_recovery.xml");
}

bool NavigateThroughPosesNavigator::goalReceived(ActionT::Goal::ConstSharedPtr goal) {
  if (bt_action_server_->loadBehaviorTree(goal->behavior_tree)) return initializeGoalPoses(goal);
  RCLCPP_ERROR(logger_, "Error loading XML file: %s. Navigation canceled.",
               goal->behavior_tree.c_str());
  return false;
}

void NavigateThroughPosesNavigator::onLoop() {
  auto feedback = std::make_shared<ActionT::Feedback>();
  const BT::Blackboard& blackboard = *bt_action_server_->getBlackboard();
  Goals goals;
  blackboard.get(goals_blackboard_id_, goals);
  geometry_msgs::msg::PoseStamped robot;
  if (!goals.empty()) {
    if (!find_robot(feedback_utils_, robot)) {
      RCLCPP_ERROR(logger_, "Robot pose is not available.");
      return;
    }
    fill_feedback(*feedback, blackboard, path_blackboard_id_, robot, *odom_smoother_);
    feedback->navigation_time = clock_->now() - start_time_;
    feedback->number_of_poses_remaining = static_cast<int16_t>(goals.size());
  }
  bt_action_server_->publishFeedback(feedback);
}

void NavigateThroughPosesNavigator::onPreempt(ActionT::Goal::ConstSharedPtr goal) {
  RCLCPP_INFO(logger_, "Received goal preemption request");
  if (!wants_same_tree(*bt_action_server_, goal->behavior_tree)) {
    RCLCPP_WARN(logger_, "%s", kOtherTree);
    bt_action_server_->terminatePendingGoal();
  } else if (!initializeGoalPoses(bt_action_server_->acceptPendingGoal())) {
    throw std::runtime_error(
        "Preemption request was rejected since the goal poses could not be transformed.");
  }
}

void NavigateThroughPosesNavigator::goalCompleted(typename ActionT::Result::SharedPtr /*result*/,
                                                  const nav2_behavior_tree::BtStatus /*status*/) {}

bool NavigateThroughPosesNavigator::initializeGoalPoses(ActionT::Goal::ConstSharedPtr goal) {
  Goals goals = goal->poses;
  for (auto& pose : goals) {
    if (!to_global_frame(feedback_utils_, logger_, pose)) return false;
  }
  if (!goals.empty()) {
    const auto& last = goals.back().pose.position;
    RCLCPP_INFO(logger_, "Begin navigating from current location through %zu poses to (%.2f, %.2f)",
                goals.size(), last.x, last.y);
  }
  start_time_ = clock_->now();
  BT::Blackboard& blackboard = *bt_action_server_->getBlackboard();
  blackboard.set("number_recoveries", 0);
  blackboard.set(goals_blackboard_id_, goals);
  return true;
}

}  // namespace nav2_bt_navigator

PLUGINLIB_EXPORT_CLASS(nav2_bt_navigator::NavigateThroughPosesNavigator, nav2_core::NavigatorBase)
