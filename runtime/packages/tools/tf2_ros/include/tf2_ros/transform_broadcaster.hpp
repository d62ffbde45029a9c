// Tells where frames are now.
#pragma once

#include <memory>
#include <vector>

#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/create_publisher.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/detail/interfaces.hpp"
#include "tf2_ros/qos.hpp"
#include "tf2_ros/visibility_control.hpp"

namespace tf2_ros {

class TransformBroadcaster {
 public:
  template <class NodeT, class AllocatorT = std::allocator<void>>
  TransformBroadcaster(NodeT&& node, const rclcpp::QoS& qos = DynamicBroadcasterQoS(),
                       const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
                           default_options<AllocatorT>())
      : TransformBroadcaster(rclcpp::node_interfaces::get_node_parameters_interface(node),
                             rclcpp::node_interfaces::get_node_topics_interface(node), qos,
                             options) {}

  template <class AllocatorT = std::allocator<void>>
  TransformBroadcaster(rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
                       rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
                       const rclcpp::QoS& qos = DynamicBroadcasterQoS(),
                       const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
                           default_options<AllocatorT>())
      : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(
            detail::Interfaces{node_parameters, node_topics}, "/tf", qos, options)) {}

  void sendTransform(const geometry_msgs::msg::TransformStamped& transform) {
    sendTransform(std::vector<geometry_msgs::msg::TransformStamped>{transform});
  }
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped>& transforms) {
    tf2_msgs::msg::TFMessage message;
    message.transforms = transforms;
    publisher_->publish(message);
  }

 private:
  template <class AllocatorT>
  static rclcpp::PublisherOptionsWithAllocator<AllocatorT> default_options() {
    rclcpp::PublisherOptionsWithAllocator<AllocatorT> options;
    options.qos_overriding_options = rclcpp::QosOverridingOptions{
        rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::Durability,
        rclcpp::QosPolicyKind::History, rclcpp::QosPolicyKind::Reliability};
    return options;
  }

  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
};

}  // namespace tf2_ros
