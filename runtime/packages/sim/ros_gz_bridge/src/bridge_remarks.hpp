// Reports what is probably wrong with a topic of a bridge, in sentences for its author. Pure.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bridge_entry.hpp"

namespace ros_gz_bridge {

/// A topic as Gazebo has it: its type of ROS, and what Gazebo does with it.
struct GzTopic {
  std::string type;
  bool is_published = false, is_read = false;
};
/// By their names in Gazebo.
using GzTopics = std::map<std::string, GzTopic>;

/// Whether Gazebo has the other end of a topic, of the type that it has there.
bool is_connected(const BridgeEntry& entry, const std::string& hidden_type, const GzTopics& topics);

/// Why nothing crosses the bridge on a topic that is not connected: its name, its direction, its
/// type.
std::string gz_remark(const BridgeEntry& entry, const std::string& hidden_type,
                      const GzTopics& topics);

/// Topics that Gazebo publishes and a bridge carries both ways; empty: none.
std::string both_ways_remark(const std::vector<BridgeEntry>& entries, const GzTopics& topics);

/// A node of ROS that has the topic with another type than the bridge. `has_pair`: a bridge can
/// carry that type too.
std::string type_remark(const BridgeEntry& entry, const std::string& node, const std::string& type,
                        bool publishes, bool has_pair);

}  // namespace ros_gz_bridge
