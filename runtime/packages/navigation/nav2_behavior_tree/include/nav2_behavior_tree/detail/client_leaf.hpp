// A leaf of a tree that asks a server: it has callbacks of its own, which run while it is ticked.
#pragma once

#include <chrono>
#include <string>
#include <utility>

#include "behaviortree_cpp/action_node.h"
#include "nav2_behavior_tree/bt_utils.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_behavior_tree {
namespace detail {

/// A shorter timeout counts as this one. Parameter files give servers 20 ms, which a busy page may
/// need for a message; a goal would fail then. It matters only where a server does not answer.
inline constexpr std::chrono::milliseconds kLeastTimeout{1000};

/// The value of a port or the blackboard's entry of that name.
std::chrono::milliseconds timeout_of(const BT::TreeNode& node, const char* name);

class ClientLeaf : public BT::ActionNodeBase {
 public:
  ClientLeaf(const std::string& name, const BT::NodeConfiguration& conf);

 protected:
  using Milliseconds = std::chrono::milliseconds;

  /// One more on the blackboard's `number_recoveries`, for a node that recovers.
  void increment_recovery_count();

  /// Logs, and throws std::runtime_error, when the server is not there. `kind`: "action" or
  /// "service".
  void require_server(bool is_there, std::string kind, const std::string& name) const;

  /// The ports of a kind of leaf, with its own.
  static BT::PortsList ports_with(BT::PortsList ports, const BT::PortsList& addition) {
    ports.insert(addition.begin(), addition.end());
    return ports;
  }

  template <typename FutureT>
  bool is_ready_within(const FutureT& future, Milliseconds timeout) {
    return callback_group_executor_.spin_until_future_complete(future, timeout) ==
           rclcpp::FutureReturnCode::SUCCESS;
  }

  Milliseconds since(const rclcpp::Time& time) const {
    return (node_->now() - time).to_chrono<Milliseconds>();
  }

  rclcpp::Node::SharedPtr node_;  ///< of the tree; nobody else spins it
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp::executors::SingleThreadedExecutor callback_group_executor_;
  Milliseconds server_timeout_{0};            ///< for an answer to a request
  Milliseconds max_timeout_{0};               ///< of one wait, so that a tick ends in its time
  Milliseconds wait_for_service_timeout_{0};  ///< for the server, when the tree is made
};

}  // namespace detail
}  // namespace nav2_behavior_tree
