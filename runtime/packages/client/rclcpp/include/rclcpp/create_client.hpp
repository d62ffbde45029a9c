// create_client for a node or its interfaces.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

namespace node_interfaces {
class NodeGraphInterface;
}

template <typename ServiceT>
typename rclcpp::Client<ServiceT>::SharedPtr create_client(
    std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
    std::shared_ptr<node_interfaces::NodeGraphInterface>,
    std::shared_ptr<node_interfaces::NodeServicesInterface> node_services,
    const std::string& service_name, const rclcpp::QoS& qos = rclcpp::ServicesQoS(),
    rclcpp::CallbackGroup::SharedPtr group = nullptr) {
  auto client = rclcpp::Client<ServiceT>::make_shared(node_base.get(), service_name, qos);
  node_services->add_client(client, group);
  return client;
}

template <typename ServiceT, typename NodeT>
typename rclcpp::Client<ServiceT>::SharedPtr create_client(
    NodeT node, const std::string& service_name, const rclcpp::QoS& qos = rclcpp::ServicesQoS(),
    rclcpp::CallbackGroup::SharedPtr group = nullptr) {
  return create_client<ServiceT>(rclcpp::node_interfaces::get_node_base_interface(node), nullptr,
                                 rclcpp::node_interfaces::get_node_services_interface(node),
                                 service_name, qos, group);
}

}  // namespace rclcpp
