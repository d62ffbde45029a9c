// See navigate_to_pose.hpp.
#include "nav2_bt_navigator/navigators/navigate_to_pose.hpp"

#include "navigators/progress.hpp"
#include "pluginlib/class_list_macros.hpp"

namespace nav2_bt_navigator {

using geometry_msgs::msg::PoseStamped;

bool NavigateToPoseNavigator::configure(rclcpp_lifecycle::LifecycleNode::WeakPtr parent_node,
                                        std::shared_ptr<nav2_util::OdomSmoother> odom_smoother) {
  const auto node = parent_node.lock();
  goal_blackboard_id_ = parameter(*node, "goal_blackboard_id", std::string("goal"));
  path_blackboard_id_ = parameter(*node, "path_blackboard_id", std::string("path"));
  odom_smoother_ = odom_smoother;
  self_client_ = rclcpp_action::create_client<ActionT>(node, getName());
  goal_sub_ = node->create_subscription<PoseStamped>(
      "goal_pose", rclcpp::SystemDefaultsQoS(),
      [this](const PoseStamped::SharedPtr pose) { onGoalPoseReceived(pose); });
  set_groot(*node, getName(), 1667, *bt_action_server_);
  return true;
}

bool NavigateToPoseNavigator::cleanup() {
  goal_sub_.reset();
  self_client_.reset();
  return true;
}

std::string NavigateToPoseNavigator::getDefaultBTFilepath(
    rclcpp_lifecycle::LifecycleNode::WeakPtr node) {
  return tree_file(*node.lock(), "default_nav_to_pose_bt_xml",
                   "navigate_to_pose_w_replanning_and_recovery.xml");
}

void NavigateToPoseNavigator::onGoalPoseReceived(const PoseStamped::SharedPtr pose) {
  ActionT::Goal goal;
  goal.pose = *pose;
  self_client_->async_send_goal(goal);
}

bool NavigateToPoseNavigator::goalReceived(ActionT::Goal::ConstSharedPtr goal) {
  if (bt_action_server_->loadBehaviorTree(goal->behavior_tree)) return initializeGoalPose(goal);
  RCLCPP_ERROR(logger_, "BT file not found: %s. Navigation canceled.", goal->behavior_tree.c_str());
  return false;
}

void NavigateToPoseNavigator::onLoop() {
  PoseStamped robot;
  if (!find_robot(feedback_utils_, robot)) {
    RCLCPP_ERROR(logger_, "Robot pose is not available.");
    return;
  }
  auto feedback = std::make_shared<ActionT::Feedback>();
  fill_feedback(*feedback, *bt_action_server_->getBlackboard(), path_blackboard_id_, robot,
                *odom_smoother_);
  feedback->navigation_time = clock_->now() - start_time_;
  bt_action_server_->publishFeedback(feedback);
}

void NavigateToPoseNavigator::onPreempt(ActionT::Goal::ConstSharedPtr goal) {
  RCLCPP_INFO(logger_, "Received goal preemption request");
  if (!wants_same_tree(*bt_action_server_, goal->behavior_tree)) {
    RCLCPP_WARN(logger_, "%s", kOtherTree);
    bt_action_server_->terminatePendingGoal();
    return;
  }
  // The goal of the moment is the pending one from here on, whatever it is.
  if (initializeGoalPose(bt_action_server_->acceptPendingGoal())) return;
  RCLCPP_WARN(logger_,
              "Preemption request was rejected since the goal pose could not be transformed. For "
              "now, continuing to track the last goal until completion.");
  bt_action_server_->terminatePendingGoal();
}

void NavigateToPoseNavigator::goalCompleted(typename ActionT::Result::SharedPtr /*result*/,
                                            const nav2_behavior_tree::BtStatus /*status*/) {}

bool NavigateToPoseNavigator::initializeGoalPose(ActionT::Goal::ConstSharedPtr goal) {
  PoseStamped robot;
  if (!find_robot(feedback_utils_, robot)) {
    RCLCPP_ERROR(logger_, "Initial robot pose is not available.");
    return false;
  }
  PoseStamped pose = goal->pose;
  if (!to_global_frame(feedback_utils_, logger_, pose)) return false;
  RCLCPP_INFO(logger_, "Begin navigating from current location (%.2f, %.2f) to (%.2f, %.2f)",
              robot.pose.position.x, robot.pose.position.y, pose.pose.position.x,
              pose.pose.position.y);
  start_time_ = clock_->now();
  BT::Blackboard& blackboard = *bt_action_server_->getBlackboard();
  blackboard.set("number_recoveries", 0);
  blackboard.set(goal_blackboard_id_, pose);
  return true;
}

}  // namespace nav2_bt_navigator

PLUGINLIB_EXPORT_CLASS(nav2_bt_navigator::NavigateToPoseNavigator, nav2_core::NavigatorBase)
