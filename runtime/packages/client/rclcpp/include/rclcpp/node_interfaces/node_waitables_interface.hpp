// Where a node's waitables are entered.
#pragma once

#include "rclcpp/callback_group.hpp"
#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"
#include "rclcpp/waitable.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeWaitablesInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeWaitablesInterface)
  virtual ~NodeWaitablesInterface() = default;

  /// Throws std::runtime_error when the group is not one of the node's.
  virtual void add_waitable(rclcpp::Waitable::SharedPtr waitable_base_ptr,
                            rclcpp::CallbackGroup::SharedPtr group) = 0;
  virtual void remove_waitable(rclcpp::Waitable::SharedPtr waitable_ptr,
                               rclcpp::CallbackGroup::SharedPtr group) noexcept = 0;
};

}  // namespace node_interfaces
}  // namespace rclcpp

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp::node_interfaces::NodeWaitablesInterface, waitables)
