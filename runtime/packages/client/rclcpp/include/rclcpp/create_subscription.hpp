// create_subscription for a node or its interfaces.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "rclcpp/detail/override_qos.hpp"
#include "rclcpp/detail/topic_statistics.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/subscription_options.hpp"

namespace rclcpp {

template <typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
          typename SubscriptionT = rclcpp::Subscription<MessageT, AllocatorT>,
          typename MessageMemoryStrategyT = typename SubscriptionT::MessageMemoryStrategyType,
          typename NodeT>
std::shared_ptr<SubscriptionT> create_subscription(
    NodeT&& node, const std::string& topic_name, const rclcpp::QoS& qos, CallbackT&& callback,
    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
        rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>(),
    typename MessageMemoryStrategyT::SharedPtr = nullptr) {
  auto topics = rclcpp::node_interfaces::get_node_topics_interface(node);
  AnySubscriptionCallback<MessageT, AllocatorT> any_callback;
  any_callback.set(std::forward<CallbackT>(callback));
  auto subscription = std::make_shared<SubscriptionT>(
      topics->get_node_base_interface(), topic_name,
      detail::override_qos(node, *topics, topic_name, qos, options.qos_overriding_options,
                           detail::QosEntity::subscription),
      std::move(any_callback), options);
  detail::add_topic_statistics(*subscription, options, *topics);
  topics->add_subscription(subscription, options.callback_group);
  return subscription;
}

template <typename MessageT, typename CallbackT, typename AllocatorT = std::allocator<void>,
          typename SubscriptionT = rclcpp::Subscription<MessageT, AllocatorT>,
          typename MessageMemoryStrategyT = typename SubscriptionT::MessageMemoryStrategyType>
std::shared_ptr<SubscriptionT> create_subscription(
    const rclcpp::node_interfaces::NodeParametersInterface::SharedPtr& node_parameters,
    const rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr& node_topics,
    const std::string& topic_name, const rclcpp::QoS& qos, CallbackT&& callback,
    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
        rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>(),
    typename MessageMemoryStrategyT::SharedPtr strategy = nullptr) {
  return create_subscription<MessageT, CallbackT, AllocatorT, SubscriptionT>(
      detail::InterfacesOfNode{node_parameters, node_topics}, topic_name, qos,
      std::forward<CallbackT>(callback), options, strategy);
}

}  // namespace rclcpp
