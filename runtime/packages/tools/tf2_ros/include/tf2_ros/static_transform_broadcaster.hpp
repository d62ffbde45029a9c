// Tells where frames are for ever; who comes later hears it too.
#pragma once

#include <algorithm>
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

class StaticTransformBroadcaster {
 public:
  template <class NodeT, class AllocatorT = std::allocator<void>>
  StaticTransformBroadcaster(NodeT&& node, const rclcpp::QoS& qos = StaticBroadcasterQoS(),
                             const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
                                 default_options<AllocatorT>())
      : StaticTransformBroadcaster(rclcpp::node_interfaces::get_node_parameters_interface(node),
                                   rclcpp::node_interfaces::get_node_topics_interface(node), qos,
                                   options) {}

  template <class AllocatorT = std::allocator<void>>
  StaticTransformBroadcaster(
      rclcpp::node_interfaces::NodeParametersInterface::SharedPtr node_parameters,
      rclcpp::node_interfaces::NodeTopicsInterface::SharedPtr node_topics,
      const rclcpp::QoS& qos = StaticBroadcasterQoS(),
      const rclcpp::PublisherOptionsWithAllocator<AllocatorT>& options =
          default_options<AllocatorT>())
      : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(
            detail::Interfaces{node_parameters, node_topics}, "/tf_static", qos, options)) {}

  void sendTransform(const geometry_msgs::msg::TransformStamped& transform) {
    sendTransform(std::vector<geometry_msgs::msg::TransformStamped>{transform});
  }
  /// Says all that it ever said again, with these new or changed.
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped>& transforms) {
    for (const auto& transform : transforms) {
      auto& all = net_message_.transforms;
      const auto known = std::find_if(all.begin(), all.end(), [&](const auto& one) {
        return one.child_frame_id == transform.child_frame_id;
      });
      if (known == all.end()) {
        all.push_back(transform);
      } else {
        *known = transform;
      }
    }
    publisher_->publish(net_message_);
  }

 private:
  template <class AllocatorT>
  static rclcpp::PublisherOptionsWithAllocator<AllocatorT> default_options() {
    rclcpp::PublisherOptionsWithAllocator<AllocatorT> options;
    options.qos_overriding_options =
        rclcpp::QosOverridingOptions{rclcpp::QosPolicyKind::Depth, rclcpp::QosPolicyKind::History,
                                     rclcpp::QosPolicyKind::Reliability};
    return options;
  }

  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
  tf2_msgs::msg::TFMessage net_message_;
};

}  // namespace tf2_ros
