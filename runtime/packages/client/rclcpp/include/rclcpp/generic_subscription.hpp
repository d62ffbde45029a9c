// A subscription to bytes whose type is known only by its name.
#pragma once

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/generic_publisher.hpp"
#include "rclcpp/node_interfaces/node_topics_interface.hpp"
#include "rclcpp/subscription_base.hpp"

namespace rclcpp {

class GenericSubscription : private detail::NamedType, public rclcpp::SubscriptionBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription)
  using Callback =
      std::function<void(const std::shared_ptr<rclcpp::SerializedMessage>&, const MessageInfo&)>;

  GenericSubscription(node_interfaces::NodeBaseInterface* node_base, const std::string& topic_name,
                      const std::string& topic_type, const rclcpp::QoS& qos, Callback callback,
                      const SubscriptionOptionsBase& options)
      : detail::NamedType(topic_type),
        SubscriptionBase(node_base, type_support(), topic_name, qos, options,
                         DeliveredMessageKind::SERIALIZED_MESSAGE),
        callback_(std::move(callback)) {}

  std::shared_ptr<void> create_message() override { return create_serialized_message(); }
  void handle_message(std::shared_ptr<void>&, const rclcpp::MessageInfo&) override {
    throw std::runtime_error("handle_message is not implemented for GenericSubscription");
  }
  void handle_serialized_message(const std::shared_ptr<rclcpp::SerializedMessage>& message,
                                 const rclcpp::MessageInfo& message_info) override {
    callback_(message, message_info);
  }

 protected:
  void handle_bytes(const uint8_t*, size_t, const rclcpp::MessageInfo&) override {}
  void handle_local(detail::LocalMessage, const rclcpp::MessageInfo&) override {}

 private:
  Callback callback_;
};

template <typename AllocatorT = std::allocator<void>>
std::shared_ptr<GenericPublisher> create_generic_publisher(
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr topics_interface,
    const std::string& topic_name, const std::string& topic_type, const rclcpp::QoS& qos,
    const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
        rclcpp::PublisherOptionsWithAllocator<AllocatorT>()) {
  auto publisher = std::make_shared<GenericPublisher>(topics_interface->get_node_base_interface(),
                                                      topic_name, topic_type, qos, options);
  topics_interface->add_publisher(publisher, options.callback_group);
  return publisher;
}

template <typename CallbackT, typename AllocatorT = std::allocator<void>>
std::shared_ptr<GenericSubscription> create_generic_subscription(
    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr topics_interface,
    const std::string& topic_name, const std::string& topic_type, const rclcpp::QoS& qos,
    CallbackT&& callback,
    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
        rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>()) {
  auto erased = [callback = std::forward<CallbackT>(callback)](
                    const std::shared_ptr<rclcpp::SerializedMessage>& message,
                    const MessageInfo& info) mutable {
    detail::InHand<SerializedMessage> in_hand;
    in_hand.mine = message;
    if constexpr (detail::takes_message_v<std::decay_t<CallbackT>, SerializedMessage>) {
      detail::call_with<SerializedMessage>(callback, in_hand);
    } else {
      detail::call_with<SerializedMessage>(callback, in_hand, info);
    }
  };
  auto subscription =
      std::make_shared<GenericSubscription>(topics_interface->get_node_base_interface(), topic_name,
                                            topic_type, qos, std::move(erased), options);
  topics_interface->add_subscription(subscription, options.callback_group);
  return subscription;
}

}  // namespace rclcpp
