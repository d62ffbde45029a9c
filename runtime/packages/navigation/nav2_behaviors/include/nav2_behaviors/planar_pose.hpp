// A pose on the ground, as collision checks have it.
#pragma once

#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"
#include "tf2/utils.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace nav2_behaviors {

inline geometry_msgs::msg::Pose2D planar_pose(const geometry_msgs::msg::Pose& pose) {
  geometry_msgs::msg::Pose2D result;
  result.x = pose.position.x;
  result.y = pose.position.y;
  result.theta = tf2::getYaw(pose.orientation);
  return result;
}

}  // namespace nav2_behaviors
