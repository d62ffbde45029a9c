// Where a node's services and clients are entered.
#pragma once

#include <string>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeServicesInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeServicesInterface)
  virtual ~NodeServicesInterface() = default;

  /// Both throw std::runtime_error when the group is not one of the node's.
  virtual void add_client(rclcpp::ClientBase::SharedPtr client_base_ptr,
                          rclcpp::CallbackGroup::SharedPtr group) = 0;
  virtual void add_service(rclcpp::ServiceBase::SharedPtr service_base_ptr,
                           rclcpp::CallbackGroup::SharedPtr group) = 0;
  virtual std::string resolve_service_name(const std::string& name,
                                           bool only_expand = false) const = 0;
};

}  // namespace node_interfaces
}  // namespace rclcpp

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp::node_interfaces::NodeServicesInterface, services)
