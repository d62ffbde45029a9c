// Topics of Gazebo Sim, which a bridge carries to ROS: see ros2wasm_sim/gz_names.hpp.
#pragma once

#include <string>

#include "plugins/plugin.hpp"
#include "ros2wasm_sim/gz_names.hpp"

namespace ros2wasm_sim {

/// The text of the first of these elements that is there, or `otherwise`.
inline std::string topic_of(const Parameters& given, const char* element,
                            const std::string& otherwise) {
  const std::string topic = given.text(element, "");
  return topic.empty() ? otherwise : topic;
}

template <typename Message>
auto publish_gz(Host& host, const std::string& gz_topic) {
  return host.node()->create_publisher<Message>(hidden_name(gz_topic), rclcpp::QoS(10));
}

template <typename Message, typename Callback>
auto subscribe_gz(Host& host, const std::string& gz_topic, Callback callback) {
  return host.node()->create_subscription<Message>(hidden_name(gz_topic), rclcpp::QoS(10),
                                                   std::move(callback));
}

}  // namespace ros2wasm_sim
