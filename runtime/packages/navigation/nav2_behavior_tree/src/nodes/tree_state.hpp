// State that several nodes look at: the robot's place, the goal, and topics.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "behaviortree_cpp/tree_node.h"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_behavior_tree {

using Goals = std::vector<geometry_msgs::msg::PoseStamped>;

rclcpp::Node::SharedPtr ros_node_of(const BT::TreeNode& node);

/// Where the robot is, by the frames of a node's ports or of the server's parameters.
class RobotPlace {
 public:
  explicit RobotPlace(const BT::TreeNode& node);

  /// False when the transform is not known. An empty `frame` stands for the port `global_frame`.
  bool find(geometry_msgs::msg::PoseStamped& pose, const std::string& frame = "") const;
  /// The same, with a debug message.
  bool find_or_note(geometry_msgs::msg::PoseStamped& pose) const;
  bool transform(const geometry_msgs::msg::PoseStamped& from,
                 geometry_msgs::msg::PoseStamped& to) const;

  static BT::PortsList ports(BT::PortsList more);

 private:
  rclcpp::Node::SharedPtr node_;
  std::shared_ptr<tf2_ros::Buffer> buffer_;
  double tolerance_ = 0.1;  ///< [s]
  std::string global_frame_;
  std::string robot_base_frame_;
};

/// Notices when the goal, or one of the goals, changes.
class GoalWatch {
 public:
  explicit GoalWatch(const BT::TreeNode& node) : node_(node) {}

  void take() { read(goal_, goals_); }
  /// Once for each change.
  bool has_changed();

  static BT::PortsList ports(BT::PortsList more = {});

 private:
  void read(geometry_msgs::msg::PoseStamped& goal, Goals& goals) const;

  const BT::TreeNode& node_;
  geometry_msgs::msg::PoseStamped goal_;
  Goals goals_;
};

/// Messages of a topic, which come while the tree asks for them.
template <typename MessageT>
class TreeTopic {
 public:
  TreeTopic(const rclcpp::Node::SharedPtr& node, const std::string& topic, const rclcpp::QoS& qos,
            std::function<void(const MessageT&)> on_message)
      : group_(node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false)) {
    executor_.add_callback_group(group_, node->get_node_base_interface());
    rclcpp::SubscriptionOptions options;
    options.callback_group = group_;
    subscription_ = node->create_subscription<MessageT>(topic, qos, std::move(on_message), options);
  }

  void receive() { executor_.spin_some(); }

 private:
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::executors::SingleThreadedExecutor executor_;
  typename rclcpp::Subscription<MessageT>::SharedPtr subscription_;
};

}  // namespace nav2_behavior_tree
