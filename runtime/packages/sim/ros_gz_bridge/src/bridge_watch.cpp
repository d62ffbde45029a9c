// See bridge_watch.hpp.
#include "bridge_watch.hpp"

#include <algorithm>

#include "ros2wasm_sim/gz_names.hpp"

namespace ros_gz_bridge {
namespace {

const rclcpp::Duration kBetweenLooks = std::chrono::seconds(2);
/// Models come one after the other, and some launch files wait before they spawn the first.
const rclcpp::Duration kWaitForMore = std::chrono::seconds(8);
const rclcpp::Duration kWaitForFirst = std::chrono::seconds(30);

bool is_of_simulator(const rclcpp::TopicEndpointInfo& end) {
  return end.node_name() == ros2wasm_sim::kServerNode;
}

GzTopics topics_of_gazebo(const rclcpp::Node& node) {
  GzTopics result;
  for (const auto& [name, types] : node.get_topic_names_and_types()) {
    const std::string hidden = ros2wasm_sim::hidden_name("");
    if (name.rfind(hidden, 0) != 0 || name == ros2wasm_sim::kWorldName ||
        ros2wasm_sim::is_of_view(name))
      continue;
    GzTopic topic;
    for (const auto& end : node.get_publishers_info_by_topic(name))
      if (is_of_simulator(end)) topic = {end.topic_type(), true, topic.is_read};
    for (const auto& end : node.get_subscriptions_info_by_topic(name))
      if (is_of_simulator(end)) topic = {end.topic_type(), topic.is_published, true};
    // The name of the topic may have had signs that ROS does not have; the bridge's has too.
    if (topic.is_published || topic.is_read) result["/" + name.substr(hidden.size())] = topic;
  }
  return result;
}

/// Only the world is there, without a model that does something.
bool is_empty(const GzTopics& topics) {
  return std::all_of(topics.begin(), topics.end(), [](const auto& topic) {
    return topic.first == "/clock" || topic.first.rfind("/world/", 0) == 0;
  });
}

bool are_same(const GzTopics& a, const GzTopics& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(),
                    [](const auto& x, const auto& y) { return x.first == y.first; });
}

}  // namespace

void BridgeWatch::look(rclcpp::Node& node) {
  const rclcpp::Time now = clock_.now();
  if (now - last_look_ < kBetweenLooks) return;
  last_look_ = now;
  for (const Topic& topic : topics_) {
    if (topic.entry.direction != Direction::kGzToRos) look_at_types(node, topic, true);
    if (topic.entry.direction != Direction::kRosToGz) look_at_types(node, topic, false);
  }
  if (std::any_of(topics_.begin(), topics_.end(), [](const Topic& one) { return !one.is_done; }) ||
      !has_said_both_ways_)
    look_at_gazebo(node, now);
}

void BridgeWatch::look_at_types(rclcpp::Node& node, const Topic& topic, bool publishers) {
  const std::string name =
      node.get_node_topics_interface()->resolve_topic_name(topic.entry.ros_topic);
  for (const auto& end : publishers ? node.get_publishers_info_by_topic(name)
                                    : node.get_subscriptions_info_by_topic(name)) {
    if (end.topic_type() == topic.entry.ros_type || end.node_name() == node.get_name() ||
        !reported_.emplace(name, end.node_name()).second)
      continue;
    const bool has_pair = find_type_pair(end.topic_type(), topic.entry.gz_type) != nullptr;
    RCLCPP_WARN(
        node.get_logger(), "%s",
        type_remark(topic.entry, end.node_name(), end.topic_type(), publishers, has_pair).c_str());
  }
}

void BridgeWatch::look_at_gazebo(rclcpp::Node& node, const rclcpp::Time& now) {
  GzTopics topics = topics_of_gazebo(node);
  for (Topic& one : topics_)
    one.is_done = one.is_done ||
                  ros2wasm_sim::is_of_view(ros2wasm_sim::hidden_name(one.entry.gz_topic)) ||
                  is_connected(one.entry, one.pair->hidden_type, topics);
  if (!are_same(topics, gazebo_)) same_since_ = now;
  gazebo_ = std::move(topics);
  if (gazebo_.empty() || now - same_since_ < (is_empty(gazebo_) ? kWaitForFirst : kWaitForMore))
    return;
  std::vector<BridgeEntry> entries;
  for (Topic& one : topics_) {
    entries.push_back(one.entry);
    if (std::exchange(one.is_done, true)) continue;
    RCLCPP_WARN(node.get_logger(), "%s",
                gz_remark(one.entry, one.pair->hidden_type, gazebo_).c_str());
  }
  if (std::exchange(has_said_both_ways_, true)) return;
  const std::string both = both_ways_remark(entries, gazebo_);
  if (!both.empty()) RCLCPP_WARN(node.get_logger(), "%s", both.c_str());
}

}  // namespace ros_gz_bridge
