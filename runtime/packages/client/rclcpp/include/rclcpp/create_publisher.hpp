// create_publisher for a node or its interfaces.
#pragma once

#include <memory>
#include <string>

#include "rclcpp/detail/override_qos.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/qos.hpp"

namespace rclcpp {

template <typename MessageT, typename AllocatorT = std::allocator<void>,
          typename PublisherT = rclcpp::Publisher<MessageT, AllocatorT>, typename NodeT>
std::shared_ptr<PublisherT> create_publisher(
    NodeT&& node, const std::string& topic_name, const rclcpp::QoS& qos,
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
        rclcpp::PublisherOptionsWithAllocator<AllocatorT>()) {
  auto topics = rclcpp::node_interfaces::get_node_topics_interface(node);
  auto publisher = std::make_shared<PublisherT>(
      topics->get_node_base_interface(), topic_name,
      detail::override_qos(node, *topics, topic_name, qos, options.qos_overriding_options,
                           detail::QosEntity::publisher),
      options);
  topics->add_publisher(publisher, options.callback_group);
  return publisher;
}

template <typename MessageT, typename AllocatorT = std::allocator<void>,
          typename PublisherT = rclcpp::Publisher<MessageT, AllocatorT>>
std::shared_ptr<PublisherT> create_publisher(
    const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr& node_parameters,
    const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr& node_topics,
    const std::string& topic_name, const rclcpp::QoS& qos,
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
        rclcpp::PublisherOptionsWithAllocator<AllocatorT>()) {
  return create_publisher<MessageT, AllocatorT, PublisherT>(
      detail::InterfacesOfNode{node_parameters, node_topics}, topic_name, qos, options);
}

}  // namespace rclcpp
