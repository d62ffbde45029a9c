// A leaf of a tree with a client of an action: its name, its ports, and the wait for its server.
#pragma once

#include <memory>
#include <string>

#include "nav2_behavior_tree/detail/client_leaf.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_behavior_tree {
namespace detail {

template <class ActionT>
class ActionLeaf : public ClientLeaf {
 public:
  /// The port `server_name` takes the place of `action_name`. Throws std::runtime_error when the
  /// server does not come in time.
  ActionLeaf(const std::string& xml_tag_name, const std::string& action_name,
             const BT::NodeConfiguration& conf)
      : ClientLeaf(xml_tag_name, conf), action_name_(action_name) {
    std::string remapped_action_name;
    if (getInput("server_name", remapped_action_name)) action_name_ = remapped_action_name;
    createActionClient(action_name_);
  }

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

 protected:
  std::string action_name_;
  std::shared_ptr<rclcpp_action::Client<ActionT>> action_client_;
};

}  // namespace detail
}  // namespace nav2_behavior_tree
