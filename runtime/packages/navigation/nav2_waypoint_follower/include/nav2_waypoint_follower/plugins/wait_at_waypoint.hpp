// Pauses at each waypoint for some milliseconds.
#pragma once

#include <string>

#include "nav2_core/waypoint_task_executor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace nav2_waypoint_follower {

class WaitAtWaypoint : public nav2_core::WaypointTaskExecutor {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name) override;
  bool processAtWaypoint(const geometry_msgs::msg::PoseStamped& curr_pose,
                         const int& curr_waypoint_index) override;

 protected:
  int waypoint_pause_duration_ = 0;  // ms
  bool is_enabled_ = true;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_waypoint_follower")};
  rclcpp::Clock::SharedPtr clock_;
};

}  // namespace nav2_waypoint_follower
