// See tree_state.hpp.
#include "nodes/tree_state.hpp"

#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_util/robot_utils.hpp"

namespace nav2_behavior_tree {

rclcpp::Node::SharedPtr ros_node_of(const BT::TreeNode& node) {
  return node.config().blackboard->get<rclcpp::Node::SharedPtr>("node");
}

RobotPlace::RobotPlace(const BT::TreeNode& node)
    : node_(ros_node_of(node)),
      buffer_(node.config().blackboard->get<std::shared_ptr<tf2_ros::Buffer>>("tf_buffer")),
      global_frame_(BT::deconflictPortAndParamFrame<std::string>(node_, "global_frame", &node)),
      robot_base_frame_(
          BT::deconflictPortAndParamFrame<std::string>(node_, "robot_base_frame", &node)) {
  node_->get_parameter("transform_tolerance", tolerance_);
}

bool RobotPlace::find(geometry_msgs::msg::PoseStamped& pose, const std::string& frame) const {
  return nav2_util::getCurrentPose(pose, *buffer_, frame.empty() ? global_frame_ : frame,
                                   robot_base_frame_, tolerance_);
}

bool RobotPlace::find_or_note(geometry_msgs::msg::PoseStamped& pose) const {
  if (find(pose)) return true;
  RCLCPP_DEBUG(node_->get_logger(), "Current robot pose is not available.");
  return false;
}

bool RobotPlace::transform(const geometry_msgs::msg::PoseStamped& from,
                           geometry_msgs::msg::PoseStamped& to) const {
  return nav2_util::transformPoseInTargetFrame(from, to, *buffer_, global_frame_, tolerance_);
}

BT::PortsList RobotPlace::ports(BT::PortsList more) {
  more.insert(BT::InputPort<std::string>("global_frame", "Frame of positions"));
  more.insert(BT::InputPort<std::string>("robot_base_frame", "Frame of the robot"));
  return more;
}

void GoalWatch::read(geometry_msgs::msg::PoseStamped& goal, Goals& goals) const {
  const BT::Blackboard& blackboard = *node_.config().blackboard;
  BT::getInputPortOrBlackboard(node_, blackboard, "goals", goals);
  BT::getInputPortOrBlackboard(node_, blackboard, "goal", goal);
}

bool GoalWatch::has_changed() {
  geometry_msgs::msg::PoseStamped goal;
  Goals goals;
  read(goal, goals);
  if (goal == goal_ && goals == goals_) return false;
  goal_ = goal;
  goals_ = std::move(goals);
  return true;
}

BT::PortsList GoalWatch::ports(BT::PortsList more) {
  more.insert(BT::InputPort<Goals>("goals", "Goals to watch"));
  more.insert(BT::InputPort<geometry_msgs::msg::PoseStamped>("goal", "Goal to watch"));
  return more;
}

}  // namespace nav2_behavior_tree
