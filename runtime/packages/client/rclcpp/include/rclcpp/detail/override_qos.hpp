// Applies QoS overrides for a publisher or subscription of a node that has parameters.
#pragma once

#include <stdexcept>
#include <string>
#include <type_traits>

#include "rclcpp/detail/qos_parameters.hpp"
#include "rclcpp/node_interfaces/node_parameters_interface.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"

namespace rclcpp {
namespace detail {

/// Publishers and subscriptions need no more of a node than this.
struct InterfacesOfNode {
  node_interfaces::NodeParametersInterface::SharedPtr parameters;
  node_interfaces::NodeTopicsInterface::SharedPtr topics;

  auto get_node_parameters_interface() const { return parameters; }
  auto get_node_topics_interface() const { return topics; }
};

template <typename NodeT, typename = void>
struct HasParameters : std::false_type {};
template <typename NodeT>
struct HasParameters<
    NodeT, std::void_t<decltype(node_interfaces::helpers::dereference(std::declval<NodeT&>())
                                    .get_node_parameters_interface())>> : std::true_type {};

template <typename NodeT>
rclcpp::QoS override_qos(NodeT& node, const node_interfaces::NodeTopicsInterface& topics,
                         const std::string& topic_name, const rclcpp::QoS& qos,
                         const rclcpp::QosOverridingOptions& options, QosEntity entity) {
  if (options.get_policy_kinds().empty()) {
    return qos;
  }
  if constexpr (HasParameters<NodeT>::value) {
    auto parameters = node_interfaces::helpers::dereference(node).get_node_parameters_interface();
    return declare_qos_parameters(options, *parameters, topics.resolve_topic_name(topic_name), qos,
                                  entity);
  } else {
    throw std::runtime_error(
        "passed non-default qos overriding options without providing a parameters interface");
  }
}

}  // namespace detail
}  // namespace rclcpp
