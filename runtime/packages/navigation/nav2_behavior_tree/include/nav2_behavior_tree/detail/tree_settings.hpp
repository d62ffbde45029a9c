// The parameters of a server that runs a tree, and what its nodes find on the blackboard.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "behaviortree_cpp/blackboard.h"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_behavior_tree {
namespace detail {

struct TreeSettings {
  std::chrono::milliseconds loop_duration{10};  ///< from tick to tick
  std::chrono::milliseconds server_timeout{20};
  std::chrono::milliseconds cancel_timeout{20};
  std::chrono::milliseconds wait_for_service_timeout{1000};
  std::chrono::nanoseconds result_timeout{0};
  bool always_reload = false;
};

void declare_tree_parameters(rclcpp_lifecycle::LifecycleNode& node);

/// Throws std::invalid_argument when the duration of a loop is not positive.
TreeSettings read_tree_settings(const rclcpp_lifecycle::LifecycleNode& node);

void write_tree_settings(BT::Blackboard& blackboard, const rclcpp::Node::SharedPtr& node,
                         const TreeSettings& settings);

/// The node that leaves of the tree use, with all parameters of the server.
rclcpp::Node::SharedPtr make_client_node(const rclcpp_lifecycle::LifecycleNode::SharedPtr& node,
                                         const std::string& action_name);

/// Nothing when no entry of these names has a code but 0.
std::optional<uint16_t> least_error_code(const BT::Blackboard& blackboard,
                                         const std::vector<std::string>& names);

}  // namespace detail
}  // namespace nav2_behavior_tree
