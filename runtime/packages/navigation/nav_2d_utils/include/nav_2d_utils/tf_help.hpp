// Poses in another frame.
#pragma once

#include <memory>
#include <string>

#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav_2d_msgs/msg/pose2_d_stamped.hpp"
#include "nav_2d_utils/conversions.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"

namespace nav_2d_utils {

/// At the time of the pose, or with the newest transform when that is not older than the tolerance.
/// False, with an error logged, when there is none.
bool transformPose(const std::shared_ptr<tf2_ros::Buffer> tf, const std::string frame,
                   const geometry_msgs::msg::PoseStamped& in_pose,
                   geometry_msgs::msg::PoseStamped& out_pose,
                   rclcpp::Duration& transform_tolerance);
bool transformPose(const std::shared_ptr<tf2_ros::Buffer> tf, const std::string frame,
                   const nav_2d_msgs::msg::Pose2DStamped& in_pose,
                   nav_2d_msgs::msg::Pose2DStamped& out_pose,
                   rclcpp::Duration& transform_tolerance);

}  // namespace nav_2d_utils
