// Fills a buffer with what comes on /tf and /tf_static.
#pragma once

#include <functional>
#include <memory>

#include "rclcpp/create_subscription.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/buffer_core.hpp"
#include "tf2/time.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/detail/background_spin.hpp"
#include "tf2_ros/detail/interfaces.hpp"
#include "tf2_ros/qos.hpp"
#include "tf2_ros/visibility_control.hpp"

namespace tf2_ros {
namespace detail {

template <class AllocatorT = std::allocator<void>>
rclcpp::SubscriptionOptionsWithAllocator<AllocatorT> get_default_transform_listener_sub_options() {
  rclcpp::SubscriptionOptionsWithAllocator<AllocatorT> options;
  options.qos_overriding_options = rclcpp::QosOverridingOptions{
      rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::Durability,
      rclcpp::QosPolicyKind::History, rclcpp::QosPolicyKind::Reliability};
  return options;
}

template <class AllocatorT = std::allocator<void>>
rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>
get_default_transform_listener_static_sub_options() {
  rclcpp::SubscriptionOptionsWithAllocator<AllocatorT> options;
  options.qos_overriding_options =
      rclcpp::QosOverridingOptions{rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::History,
                                   rclcpp::QosPolicyKind::Reliability};
  return options;
}

}  // namespace detail

/// With `spin_thread` the buffer is filled whenever the program waits, in whatever way; else by
/// the executor of the node.
class TransformListener {
 public:
  /// Makes a node of its own.
  explicit TransformListener(tf2::BufferCore& buffer, bool spin_thread = true);

  template <class NodeT, class AllocatorT = std::allocator<void>>
  TransformListener(tf2::BufferCore& buffer, NodeT&& node, bool spin_thread = true,
                    const rclcpp::QoS& qos = DynamicListenerQoS(),
                    const rclcpp::QoS& static_qos = StaticListenerQoS(),
                    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
                        detail::get_default_transform_listener_sub_options<AllocatorT>(),
                    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& static_options =
                        detail::get_default_transform_listener_static_sub_options<AllocatorT>())
      : TransformListener(buffer, node->get_node_base_interface(),
                          node->get_node_logging_interface(), node->get_node_parameters_interface(),
                          node->get_node_topics_interface(), spin_thread, qos, static_qos, options,
                          static_options) {}

  template <class AllocatorT = std::allocator<void>>
  TransformListener(tf2::BufferCore& buffer,
                    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
                    rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging,
                    rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
                    rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
                    bool spin_thread = true, const rclcpp::QoS& qos = DynamicListenerQoS(),
                    const rclcpp::QoS& static_qos = StaticListenerQoS(),
                    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& options =
                        detail::get_default_transform_listener_sub_options<AllocatorT>(),
                    const rclcpp::SubscriptionOptionsWithAllocator<AllocatorT>& static_options =
                        detail::get_default_transform_listener_static_sub_options<AllocatorT>())
      : buffer_(buffer), node_logging_interface_(node_logging) {
    listen(node_base, node_parameters, node_topics, spin_thread, qos, static_qos, options,
           static_options);
  }

  virtual ~TransformListener();

  virtual void subscription_callback(tf2_msgs::msg::TFMessage::ConstSharedPtr msg, bool is_static);

 private:
  template <class AllocatorT>
  void listen(rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
              rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
              rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics, bool spin_thread,
              const rclcpp::QoS& qos, const rclcpp::QoS& static_qos,
              rclcpp::SubscriptionOptionsWithAllocator<AllocatorT> options,
              rclcpp::SubscriptionOptionsWithAllocator<AllocatorT> static_options) {
    rclcpp::CallbackGroup::SharedPtr group;
    if (spin_thread) {
      group = node_base->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
      // Messages that are passed within the process would not wake the group.
      for (auto* changed : {&options, &static_options}) {
        changed->callback_group = group;
        changed->use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;
      }
    }
    const detail::Interfaces interfaces{node_parameters, node_topics};
    using Message = tf2_msgs::msg::TFMessage;
    using Callback = std::function<void(Message::ConstSharedPtr)>;
    subscription_ = rclcpp::create_subscription<Message>(
        interfaces, "/tf", qos, Callback([this](Message::ConstSharedPtr message) {
          subscription_callback(message, false);
        }),
        options);
    static_subscription_ = rclcpp::create_subscription<Message>(
        interfaces, "/tf_static", static_qos,
        Callback([this](Message::ConstSharedPtr message) { subscription_callback(message, true); }),
        static_options);
    if (spin_thread) {
      background_ = std::make_unique<detail::BackgroundSpin>(
          group, node_base,
          std::vector<rclcpp::SubscriptionBase::SharedPtr>{subscription_, static_subscription_});
      buffer_.setUsingDedicatedThread(true);
    }
  }

  tf2::BufferCore& buffer_;
  rclcpp::Node::SharedPtr own_node_;
  rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr node_logging_interface_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr subscription_;
  rclcpp::Subscription<tf2_msgs::msg::TFMessage>::SharedPtr static_subscription_;
  std::unique_ptr<detail::BackgroundSpin> background_;
};

}  // namespace tf2_ros
