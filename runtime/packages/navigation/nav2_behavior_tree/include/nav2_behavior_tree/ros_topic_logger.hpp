// Publishes the changes of a tree's nodes on behavior_tree_log.
#pragma once

#include <vector>

#include "behaviortree_cpp/loggers/abstract_logger.h"
#include "nav2_msgs/msg/behavior_tree_log.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_behavior_tree {

class RosTopicLogger : public BT::StatusChangeLogger {
 public:
  RosTopicLogger(const rclcpp::Node::WeakPtr& ros_node, const BT::Tree& tree);

  void callback(BT::Duration timestamp, const BT::TreeNode& node, BT::NodeStatus prev_status,
                BT::NodeStatus status) override;
  /// Publishes what changed since the last time.
  void flush() override;

 protected:
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("bt_navigator")};
  rclcpp::Publisher<nav2_msgs::msg::BehaviorTreeLog>::SharedPtr log_pub_;
  std::vector<nav2_msgs::msg::BehaviorTreeStatusChange> event_log_;
};

}  // namespace nav2_behavior_tree
