// Looks at the graph for mistakes of a bridge, and reports each once.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bridge_remarks.hpp"
#include "rclcpp/rclcpp.hpp"
#include "type_pairs.hpp"

namespace ros_gz_bridge {

class BridgeWatch {
 public:
  void add(const BridgeEntry& entry, const TypePair& pair) { topics_.push_back({entry, &pair}); }

  /// To be called about once a second.
  void look(rclcpp::Node& node);

 private:
  struct Topic {
    BridgeEntry entry;
    const TypePair* pair;
    bool is_done = false;  ///< connected once, or reported
  };

  void look_at_types(rclcpp::Node& node, const Topic& topic, bool publishers);
  void look_at_gazebo(rclcpp::Node& node, const rclcpp::Time& now);

  std::vector<Topic> topics_;
  std::set<std::pair<std::string, std::string>> reported_;  ///< topics and nodes of ROS
  bool has_said_both_ways_ = false;
  rclcpp::Clock clock_{RCL_STEADY_TIME};
  rclcpp::Time last_look_{0, 0, RCL_STEADY_TIME};
  GzTopics gazebo_;  ///< as it was last
  rclcpp::Time same_since_{0, 0, RCL_STEADY_TIME};
};

}  // namespace ros_gz_bridge
