// Saves the latest picture of a camera at each waypoint.
#pragma once

#include <filesystem>
#include <mutex>
#include <string>

#include "nav2_core/waypoint_task_executor.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace nav2_waypoint_follower {

class PhotoAtWaypoint : public nav2_core::WaypointTaskExecutor {
 public:
  void initialize(const rclcpp_lifecycle::LifecycleNode::WeakPtr& parent,
                  const std::string& plugin_name) override;
  /// False when no image has come, or it cannot be written.
  bool processAtWaypoint(const geometry_msgs::msg::PoseStamped& curr_pose,
                         const int& curr_waypoint_index) override;
  void imageCallback(const sensor_msgs::msg::Image::SharedPtr msg);

 protected:
  /// False when the folder is not there and cannot be made.
  bool makeFolder();

  std::mutex global_mutex_;
  std::filesystem::path save_dir_;
  std::string image_format_;
  std::string image_topic_;
  bool is_enabled_ = true;
  sensor_msgs::msg::Image::SharedPtr curr_frame_msg_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_waypoint_follower")};
  rclcpp::Subscription<sensor_msgs::msg::Image>::SharedPtr camera_image_subscriber_;
};

}  // namespace nav2_waypoint_follower
