// A node's publishers and subscriptions, for real.
#pragma once

#include <string>

#include "rclcpp/node_interfaces/node_topics_interface.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeTopics : public NodeTopicsInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeTopics)
  NodeTopics(NodeBaseInterface* node_base, NodeTimersInterface* node_timers)
      : node_base_(node_base), node_timers_(node_timers) {}

  void add_publisher(rclcpp::PublisherBase::SharedPtr publisher,
                     rclcpp::CallbackGroup::SharedPtr callback_group) override;
  void add_subscription(rclcpp::SubscriptionBase::SharedPtr subscription,
                        rclcpp::CallbackGroup::SharedPtr callback_group) override;
  NodeBaseInterface* get_node_base_interface() const override { return node_base_; }
  NodeTimersInterface* get_node_timers_interface() const override { return node_timers_; }
  std::string resolve_topic_name(const std::string& name, bool only_expand = false) const override;

 private:
  RCLCPP_DISABLE_COPY(NodeTopics)
  NodeBaseInterface* node_base_;
  NodeTimersInterface* node_timers_;
};

}  // namespace node_interfaces
}  // namespace rclcpp
