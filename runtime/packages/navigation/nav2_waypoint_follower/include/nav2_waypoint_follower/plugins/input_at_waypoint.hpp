// Waits at each waypoint until a message comes.
#pragma once

#include <mutex>
#include <string>

#include "nav2_core/waypoint_task_executor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "std_msgs/msg/empty.hpp"

namespace nav2_waypoint_follower {

class InputAtWaypoint : public nav2_core::WaypointTaskExecutor {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name) override;
  /// False when no message came in time.
  bool processAtWaypoint(const geometry_msgs::msg::PoseStamped& curr_pose,
                         const int& curr_waypoint_index) override;

 protected:
  void Cb(const std_msgs::msg::Empty::SharedPtr msg);
  bool isReceived();

  bool input_received_ = false;
  bool is_enabled_ = true;
  rclcpp::Duration timeout_{10, 0};
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_waypoint_follower")};
  rclcpp::Clock::SharedPtr clock_;
  std::mutex mutex_;
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr subscription_;
};

}  // namespace nav2_waypoint_follower
