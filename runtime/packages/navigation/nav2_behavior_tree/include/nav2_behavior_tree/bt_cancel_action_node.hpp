// A leaf that cancels all goals of an action server.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "behaviortree_cpp/action_node.h"
#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_behavior_tree/detail/client_leaf.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_behavior_tree {

template <class ActionT>
class BtCancelActionNode : public detail::ClientLeaf {
 public:
  /// Throws std::runtime_error when the server does not come in time.
  BtCancelActionNode(const std::string& xml_tag_name, const std::string& action_name,
                     const BT::NodeConfiguration& conf)
      : detail::ClientLeaf(xml_tag_name, conf), action_name_(action_name) {
    std::string remapped_action_name;
    if (getInput("server_name", remapped_action_name)) action_name_ = remapped_action_name;
    createActionClient(action_name_);
  }
  BtCancelActionNode() = delete;
  ~BtCancelActionNode() override = default;

  void createActionClient(const std::string& action_name) {
    action_client_ = rclcpp_action::create_client<ActionT>(node_, action_name, callback_group_);
    require_server(action_client_->wait_for_action_server(wait_for_service_timeout_), "action",
                   action_name);
  }

  /// The ports of every such node, with those of one class.
  static BT::PortsList providedBasicPorts(BT::PortsList addition) {
    return ports_with({BT::InputPort<std::string>("server_name", "Action server name"),
                       BT::InputPort<std::chrono::milliseconds>("server_timeout")},
                      addition);
  }
  static BT::PortsList providedPorts() { return providedBasicPorts({}); }

  void halt() override {}

  BT::NodeStatus tick() override {
    setStatus(BT::NodeStatus::RUNNING);
    // Not a goal that the tree sent a moment ago.
    const rclcpp::Time before = node_->now() - rclcpp::Duration(std::chrono::milliseconds(10));
    if (is_ready_within(action_client_->async_cancel_goals_before(before), server_timeout_)) {
      return BT::NodeStatus::SUCCESS;
    }
    RCLCPP_ERROR(node_->get_logger(), "Failed to cancel the action server for %s",
                 action_name_.c_str());
    return BT::NodeStatus::FAILURE;
  }

 protected:
  std::string action_name_;
  std::shared_ptr<rclcpp_action::Client<ActionT>> action_client_;
};

}  // namespace nav2_behavior_tree
