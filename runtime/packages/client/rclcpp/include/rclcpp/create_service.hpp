// create_service for a node or its interfaces.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/node_interfaces/node_services_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/service.hpp"

namespace rclcpp {

template <typename ServiceT, typename CallbackT>
typename rclcpp::Service<ServiceT>::SharedPtr create_service(
    std::shared_ptr<node_interfaces::NodeBaseInterface> node_base,
    std::shared_ptr<node_interfaces::NodeServicesInterface> node_services,
    const std::string& service_name, CallbackT&& callback, const rclcpp::QoS& qos,
    rclcpp::CallbackGroup::SharedPtr group) {
  AnyServiceCallback<ServiceT> any_callback;
  any_callback.set(std::forward<CallbackT>(callback));
  auto service = rclcpp::Service<ServiceT>::make_shared(node_base.get(), service_name,
                                                        std::move(any_callback), qos);
  node_services->add_service(service, group);
  return service;
}

template <typename ServiceT, typename CallbackT, typename NodeT>
typename rclcpp::Service<ServiceT>::SharedPtr create_service(
    NodeT node, const std::string& service_name, CallbackT&& callback,
    const rclcpp::QoS& qos = rclcpp::ServicesQoS(),
    rclcpp::CallbackGroup::SharedPtr group = nullptr) {
  return create_service<ServiceT>(rclcpp::node_interfaces::get_node_base_interface(node),
                                  rclcpp::node_interfaces::get_node_services_interface(node),
                                  service_name, std::forward<CallbackT>(callback), qos, group);
}

}  // namespace rclcpp
