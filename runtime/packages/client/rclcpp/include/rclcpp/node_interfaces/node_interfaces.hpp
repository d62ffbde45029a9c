// Some interfaces of a node, of whatever class, as one argument.
#pragma once

#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

#include "rclcpp/node_interfaces/detail/node_interfaces_helpers.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_graph_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/node_interfaces/node_time_source_interface.hpp"
#include "rclcpp/node_interfaces/node_timers_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/node_interfaces/node_type_descriptions_interface.hpp"
#include "rclcpp/node_interfaces/node_waitables_interface.hpp"

#define ALL_RCLCPP_NODE_INTERFACES                                                                \
  rclcpp::node_interfaces::NodeBaseInterface, rclcpp::node_interfaces::NodeClockInterface,        \
      rclcpp::node_interfaces::NodeGraphInterface, rclcpp::node_interfaces::NodeLoggingInterface, \
      rclcpp::node_interfaces::NodeParametersInterface,                                           \
      rclcpp::node_interfaces::NodeServicesInterface,                                             \
      rclcpp::node_interfaces::NodeTimeSourceInterface,                                           \
      rclcpp::node_interfaces::NodeTimersInterface, rclcpp::node_interfaces::NodeTopicsInterface, \
      rclcpp::node_interfaces::NodeTypeDescriptionsInterface,                                     \
      rclcpp::node_interfaces::NodeWaitablesInterface

namespace rclcpp::node_interfaces {

/// Has a getter for each of its interfaces, named as a node's, so it stands for the node where
/// something is created. Made of a node, or of other NodeInterfaces with at least these.
template <typename... InterfaceTs>
class NodeInterfaces
    : public helpers::InterfaceOf<InterfaceTs>::template Getter<NodeInterfaces<InterfaceTs...>>... {
 public:
  NodeInterfaces() = default;
  template <typename NodeT, typename = std::enable_if_t<!helpers::IsPointer<NodeT>::value>>
  NodeInterfaces(NodeT& node)  // NOLINT: not explicit, as functions take it for a node
      : interfaces_(helpers::InterfaceOf<InterfaceTs>::get(node)...) {}
  explicit NodeInterfaces(std::shared_ptr<InterfaceTs>... interfaces)
      : interfaces_(std::move(interfaces)...) {}

  template <typename InterfaceT>
  std::shared_ptr<InterfaceT> get() const {
    return std::get<std::shared_ptr<InterfaceT>>(interfaces_);
  }
  template <typename InterfaceT>
  void set(std::shared_ptr<InterfaceT> interface) {
    std::get<std::shared_ptr<InterfaceT>>(interfaces_) = std::move(interface);
  }

 private:
  std::tuple<std::shared_ptr<InterfaceTs>...> interfaces_;
};

}  // namespace rclcpp::node_interfaces
