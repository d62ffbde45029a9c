// The base of plugins that do something at each waypoint.
#pragma once

#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_core {

class WaypointTaskExecutor {
 public:
  WaypointTaskExecutor() {}
  virtual ~WaypointTaskExecutor() {}

  virtual void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                          const std::string& plugin_name) = 0;
  /// Whether it was done.
  virtual bool processAtWaypoint(const geometry_msgs::msg::PoseStamped& curr_pose,
                                 const int& curr_waypoint_index) = 0;
};

}  // namespace nav2_core
