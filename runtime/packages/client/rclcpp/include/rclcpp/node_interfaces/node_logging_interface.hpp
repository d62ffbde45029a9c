// A node's logger.
#pragma once

#include "rclcpp/logger.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"

namespace rclcpp {
namespace node_interfaces {

class NodeServicesInterface;
class NodeBaseInterface;

class NodeLoggingInterface {
 public:
  RCLCPP_SMART_PTR_ALIASES_ONLY(NodeLoggingInterface)
  virtual ~NodeLoggingInterface() = default;

  virtual rclcpp::Logger get_logger() const = 0;
  virtual const char* get_logger_name() const = 0;
  /// Offers ~/get_logger_levels and ~/set_logger_levels.
  virtual void create_logger_services(NodeBaseInterface* node_base,
                                      NodeServicesInterface* node_services) = 0;
};

}  // namespace node_interfaces
}  // namespace rclcpp

RCLCPP_NODE_INTERFACE_HELPERS_SUPPORT(rclcpp::node_interfaces::NodeLoggingInterface, logging)
