// See ros_topic_logger.hpp.
#include "nav2_behavior_tree/ros_topic_logger.hpp"

#include <chrono>
#include <memory>
#include <string>
#include <utility>

#include "nav2_msgs/msg/behavior_tree_status_change.hpp"

namespace nav2_behavior_tree {

RosTopicLogger::RosTopicLogger(const rclcpp::Node::WeakPtr& ros_node, const BT::Tree& tree)
    : StatusChangeLogger(tree.rootNode()) {
  const auto node = ros_node.lock();
  clock_ = node->get_clock();
  logger_ = node->get_logger();
  log_pub_ =
      node->create_publisher<nav2_msgs::msg::BehaviorTreeLog>("behavior_tree_log", rclcpp::QoS(10));
}

void RosTopicLogger::callback(BT::Duration timestamp, const BT::TreeNode& node,
                              BT::NodeStatus prev_status, BT::NodeStatus status) {
  nav2_msgs::msg::BehaviorTreeStatusChange event;
  const auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(timestamp);
  event.timestamp = rclcpp::Time(nanoseconds.count());
  event.node_name = node.name();
  event.uid = node.UID();
  event.previous_status = BT::toStr(prev_status, false);
  event.current_status = BT::toStr(status, false);
  RCLCPP_DEBUG(logger_, "[%.3f]: %25s %s -> %s", std::chrono::duration<double>(timestamp).count(),
               node.name().c_str(), event.previous_status.c_str(), event.current_status.c_str());
  event_log_.push_back(std::move(event));
}

void RosTopicLogger::flush() {
  if (event_log_.empty()) return;
  auto message = std::make_unique<nav2_msgs::msg::BehaviorTreeLog>();
  message->timestamp = clock_->now();
  message->event_log = std::move(event_log_);
  event_log_.clear();
  log_pub_->publish(std::move(message));
}

}  // namespace nav2_behavior_tree
