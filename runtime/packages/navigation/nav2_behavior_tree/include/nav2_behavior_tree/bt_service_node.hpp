// A leaf that calls a service, and runs until the answer comes.
#pragma once

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "behaviortree_cpp/action_node.h"
#include "behaviortree_cpp/json_export.h"
#include "nav2_behavior_tree/bt_utils.hpp"
#include "nav2_behavior_tree/detail/client_leaf.hpp"
#include "nav2_behavior_tree/json_utils.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_behavior_tree {

using namespace std::chrono_literals;

template <class ServiceT>
class BtServiceNode : public detail::ClientLeaf {
 public:
  /// The port `service_name` takes the place of `service_name`. Throws std::runtime_error when the
  /// server does not come in time.
  BtServiceNode(const std::string& service_node_name, const BT::NodeConfiguration& conf,
                const std::string& service_name = "")
      : detail::ClientLeaf(service_node_name, conf),
        service_name_(service_name),
        service_node_name_(service_node_name) {
    getInput("service_name", service_name_);
    service_client_ =
        node_->create_client<ServiceT>(service_name_, rclcpp::SystemDefaultsQoS(), callback_group_);
    request_ = std::make_shared<typename ServiceT::Request>();
    require_server(service_client_->wait_for_service(wait_for_service_timeout_), "service",
                   service_name_);
  }
  BtServiceNode() = delete;
  ~BtServiceNode() override = default;

  /// The ports of every such node, with those of one class.
  static BT::PortsList providedBasicPorts(BT::PortsList addition) {
    return ports_with(
        {BT::InputPort<std::string>("service_name", "please_set_service_name_in_BT_Node"),
         BT::InputPort<std::chrono::milliseconds>("server_timeout")},
        addition);
  }
  static BT::PortsList providedPorts() { return providedBasicPorts({}); }

  BT::NodeStatus tick() override {
    if (!request_sent_) {
      should_send_request_ = true;
      request_ = std::make_shared<typename ServiceT::Request>();
      on_tick();
      if (!should_send_request_) return BT::NodeStatus::FAILURE;
      future_result_ = service_client_->async_send_request(request_).share();
      sent_time_ = node_->now();
      request_sent_ = true;
    }
    return check_future();
  }

  void halt() override {
    request_sent_ = false;
    resetStatus();
  }

  // For subclasses.

  /// Fills in `request_`. Setting `should_send_request_` to false fails.
  virtual void on_tick() {}
  virtual BT::NodeStatus on_completion(std::shared_ptr<typename ServiceT::Response> /*response*/) {
    return BT::NodeStatus::SUCCESS;
  }
  virtual void on_wait_for_result() {}

  virtual BT::NodeStatus check_future() {
    const auto remaining = server_timeout_ - since(sent_time_);
    if (remaining > std::chrono::milliseconds(0)) {
      if (is_ready_within(future_result_, std::min(remaining, max_timeout_))) {
        request_sent_ = false;
        return on_completion(future_result_.get());
      }
      on_wait_for_result();
      if (rclcpp::ok() && since(sent_time_) < server_timeout_) return BT::NodeStatus::RUNNING;
    }
    RCLCPP_WARN(node_->get_logger(), "Node timed out while executing service call to %s.",
                service_name_.c_str());
    request_sent_ = false;
    return BT::NodeStatus::FAILURE;
  }

 protected:
  std::string service_name_, service_node_name_;
  std::shared_ptr<rclcpp::Client<ServiceT>> service_client_;
  std::shared_ptr<typename ServiceT::Request> request_;
  std::shared_future<typename ServiceT::Response::SharedPtr> future_result_;
  bool request_sent_ = false;
  rclcpp::Time sent_time_;
  bool should_send_request_ = true;
};

}  // namespace nav2_behavior_tree
