// See bridge_remarks.hpp.
#include "bridge_remarks.hpp"

#include <algorithm>

#include "ros2wasm_sim/gz_names.hpp"
#include "sdf/nearest_name.hpp"

namespace ros_gz_bridge {
namespace {

std::string with_slash(const std::string& topic) {
  return topic.empty() || topic.front() == '/' ? topic : "/" + topic;
}

/// As topics of Gazebo are named here: signs that ROS does not have are `_`.
std::string gz_name(const std::string& topic) {
  return "/" + ros2wasm_sim::hidden_name(topic).substr(ros2wasm_sim::hidden_name("").size());
}

/// As parameter_bridge takes it.
std::string argument(const std::string& topic, const BridgeEntry& entry,
                     const std::string& ros_type, char direction) {
  return "`" + topic + "@" + ros_type + direction + entry.gz_type + "`";
}

std::string last_part(const std::string& topic) {
  return topic.substr(topic.rfind('/') + 1);
}

/// The topic that was probably meant: one with the same last part, or else with a similar name, or
/// else the only one of the type.
std::string meant_by(const std::string& topic, const std::vector<std::string>& others) {
  for (const std::string& other : others)
    if (last_part(other) == last_part(topic)) return other;
  const std::string nearest = ros2wasm_sim::nearest_name(topic, others);
  return nearest.empty() && others.size() == 1 ? others.front() : nearest;
}

std::string listed(const GzTopics& topics, bool published) {
  constexpr std::size_t kMost = 8;
  std::string result;
  std::size_t count = 0;
  for (const auto& [name, topic] : topics) {
    if (!(published ? topic.is_published : topic.is_read)) continue;
    if (++count <= kMost) result += (result.empty() ? "" : ", ") + name;
  }
  if (count > kMost) result += " and " + std::to_string(count - kMost) + " more";
  return result.empty() ? "none" : result;
}

}  // namespace

bool is_connected(const BridgeEntry& entry, const std::string& hidden_type,
                  const GzTopics& topics) {
  const auto found = topics.find(gz_name(entry.gz_topic));
  if (found == topics.end() || found->second.type != hidden_type) return false;
  return (entry.direction != Direction::kRosToGz && found->second.is_published) ||
         (entry.direction != Direction::kGzToRos && found->second.is_read);
}

std::string gz_remark(const BridgeEntry& entry, const std::string& hidden_type,
                      const GzTopics& topics) {
  const std::string wanted = gz_name(entry.gz_topic);
  const bool to_ros = entry.direction != Direction::kRosToGz;
  const auto found = topics.find(wanted);
  if (found != topics.end() && found->second.type != hidden_type)
    return "Gazebo's topic [" + wanted + "] is not of the type " + entry.gz_type +
           ": in ROS it is " + found->second.type + ", so nothing crosses the bridge";
  if (found != topics.end())
    return "the bridge of [" + wanted + "] goes the wrong way: Gazebo " +
           (to_ros ? "reads it. Write " : "publishes it. Write ") +
           argument(wanted, entry, entry.ros_type, to_ros ? ']' : '[') + ", or in a YAML file " +
           (to_ros ? "`direction: ROS_TO_GZ`" : "`direction: GZ_TO_ROS`");
  const std::string text =
      std::string("nothing in Gazebo ") + (to_ros ? "publishes" : "reads") + " [" + wanted + "]";
  std::vector<std::string> others;
  for (const auto& [name, topic] : topics)
    if (topic.type == hidden_type && (to_ros ? topic.is_published : topic.is_read))
      others.push_back(name);
  const std::string meant = meant_by(wanted, others);
  if (!meant.empty())
    return text + "; the nearest topic is [" + meant + "]. Write " +
           argument(meant, entry, entry.ros_type, to_ros ? '[' : ']') + " and remap it (`" + meant +
           ":=" + with_slash(entry.ros_topic) + "`), or give the plugin or sensor a <topic>";
  return text + ". Topics that it " + (to_ros ? "publishes: " : "reads: ") +
         listed(topics, to_ros) + ". Is the model there, with its plugin or sensor?";
}

std::string both_ways_remark(const std::vector<BridgeEntry>& entries, const GzTopics& topics) {
  std::string names;
  const BridgeEntry* first = nullptr;
  for (const BridgeEntry& entry : entries) {
    const auto found = topics.find(gz_name(entry.gz_topic));
    if (entry.direction != Direction::kBoth || found == topics.end() ||
        !found->second.is_published || found->second.is_read)
      continue;
    if (first == nullptr) first = &entry;
    names += (names.empty() ? "[" : ", [") + found->first + "]";
  }
  if (first == nullptr) return "";
  return "the bridge carries " + names +
         " both ways, but only Gazebo publishes there: write `[` in place of the second `@`, " +
         argument(gz_name(first->gz_topic), *first, first->ros_type, '[');
}

std::string type_remark(const BridgeEntry& entry, const std::string& node, const std::string& type,
                        bool publishes, bool has_pair) {
  const std::string topic = with_slash(entry.ros_topic);
  std::string text = "[" + node + "] " + (publishes ? "publishes [" : "reads [") + topic + "] as " +
                     type + ", but the bridge has it as " + entry.ros_type +
                     ", so no message arrives. ";
  if (has_pair)
    text += "Write " + argument(gz_name(entry.gz_topic), entry, type, publishes ? ']' : '[') +
            ", or let the node use " + entry.ros_type;
  else
    text += "Let the node use " + entry.ros_type;
  if (type.find("/Twist") != std::string::npos)
    text += " (many nodes have a parameter for it, such as `stamped` or `use_stamped`)";
  return text;
}

}  // namespace ros_gz_bridge
