// Where a node's publishers and subscriptions are entered.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_timers_interface.hpp"
#include "rclcpp/publisher_base.hpp"
#include "rclcpp/subscription_base.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeTopicsInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTopicsInterface)
  virtual ~NodeTopicsInterface() = default;

  /// Throws std::runtime_error when the group is not one of the node's.
  virtual void add_publisher(rclcpp::PublisherBase::SharedPtr publisher,
                             rclcpp::CallbackGroup::SharedPtr callback_group) = 0;
  virtual void add_subscription(rclcpp::SubscriptionBase::SharedPtr subscription,
                                rclcpp::CallbackGroup::SharedPtr callback_group) = 0;
  virtual rclcpp::node_interfaces::NodeBaseInterface* get_node_base_interface() const = 0;
  virtual rclcpp::node_interfaces::NodeTimersInterface* get_node_timers_interface() const = 0;
  virtual std::string resolve_topic_name(const std::string& name,
                                         bool only_expand = false) const = 0;
};

}  // namespace node_interfaces
}  // namespace rclcpp

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp::node_interfaces::NodeTopicsInterface, topics)
