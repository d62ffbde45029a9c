// The warning of a spawner when nobody sends it the description of the robot.
#pragma once

#include <algorithm>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace ros2wasm_sim {

/// To be said once, after 5 s without a message. `topic` as it was given.
inline std::string silent_description(rclcpp::Node& node, const std::string& topic) {
  const std::string name = node.get_node_topics_interface()->resolve_topic_name(topic);
  const auto publishers = node.get_publishers_info_by_topic(name);
  if (!publishers.empty()) {
    const auto& first = publishers.front();
    const std::string who = "[" + first.node_name() + "] publishes [" + name + "], but ";
    if (first.topic_type() != "std_msgs/msg/String")
      return who + "as " + first.topic_type() + " in place of std_msgs/msg/String";
    return who + (first.qos_profile().durability() == rclcpp::DurabilityPolicy::TransientLocal
                      ? "has sent nothing yet: is its robot_description empty?"
                      : "not with transient local durability, so what it sent before is lost");
  }
  std::string text =
      "nobody publishes [" + name +
      "]: robot_state_publisher does, when it runs in the same namespace and has the "
      "parameter `robot_description`";
  for (const auto& [other, types] : node.get_topic_names_and_types()) {
    const std::string ending = "/robot_description";
    const bool is_description =
        other.size() >= ending.size() &&
        other.compare(other.size() - ending.size(), ending.size(), ending) == 0;
    if (is_description && other != name && node.count_publishers(other) > 0)
      return text + ". There is [" + other + "]: write `-topic " + other + "`";
  }
  return text;
}

}  // namespace ros2wasm_sim
