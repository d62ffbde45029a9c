// A leaf that cancels all goals of an action server.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "behaviortree_cpp/action_node.h"
#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_behavior_tree/detail/action_leaf.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_behavior_tree {

template <class ActionT>
class BtCancelActionNode : public detail::ActionLeaf<ActionT> {
 public:
  /// Throws std::runtime_error when the server does not come in time.
  using detail::ActionLeaf<ActionT>::ActionLeaf;

  void halt() override {}

  BT::NodeStatus tick() override {
    this->setStatus(BT::NodeStatus::RUNNING);
    // Not a goal that the tree sent a moment ago.
    const rclcpp::Time before =
        this->node_->now() - rclcpp::Duration(std::chrono::milliseconds(10));
    if (this->is_ready_within(this->action_client_->async_cancel_goals_before(before),
                              this->server_timeout_)) {
      return BT::NodeStatus::SUCCESS;
    }
    RCLCPP_ERROR(this->node_->get_logger(), "Failed to cancel the action server for %s",
                 this->action_name_.c_str());
    return BT::NodeStatus::FAILURE;
  }
};

}  // namespace nav2_behavior_tree
