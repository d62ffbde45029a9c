// Whether messages have numbers that can be used.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "geometry_msgs/msg/pose_with_covariance_stamped.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"
#include "nav_msgs/msg/odometry.hpp"

namespace nav2_util {

const int NSEC_PER_SEC = 1000000000;
/// How far the squared length of an orientation may be from 1.
const double epsilon = 1e-4;
/// m/cell
const double MIN_MAP_RESOLUTION = 1e-6;

inline bool validateMsg(const double& num) {
  return std::isfinite(num);
}

template <size_t N>
bool validateMsg(const std::array<double, N>& msg) {
  for (const double& element : msg) {
    if (!validateMsg(element)) return false;
  }
  return true;
}

inline bool validateMsg(const builtin_interfaces::msg::Time& msg) {
  return msg.nanosec < static_cast<uint32_t>(NSEC_PER_SEC);
}

inline bool validateMsg(const std_msgs::msg::Header& msg) {
  return validateMsg(msg.stamp) && !msg.frame_id.empty();
}

inline bool validateMsg(const geometry_msgs::msg::Point& msg) {
  return validateMsg(msg.x) && validateMsg(msg.y) && validateMsg(msg.z);
}

inline bool validateMsg(const geometry_msgs::msg::Quaternion& msg) {
  const double square = msg.x * msg.x + msg.y * msg.y + msg.z * msg.z + msg.w * msg.w;
  return std::isfinite(square) && std::abs(square - 1.0) < epsilon;
}

inline bool validateMsg(const geometry_msgs::msg::Pose& msg) {
  return validateMsg(msg.position) && validateMsg(msg.orientation);
}

inline bool validateMsg(const geometry_msgs::msg::PoseWithCovariance& msg) {
  return validateMsg(msg.pose) && validateMsg(msg.covariance);
}

inline bool validateMsg(const geometry_msgs::msg::PoseWithCovarianceStamped& msg) {
  return validateMsg(msg.header) && validateMsg(msg.pose);
}

inline bool validateMsg(const nav_msgs::msg::MapMetaData& msg) {
  return validateMsg(msg.origin) && validateMsg(msg.resolution) &&
         msg.resolution > MIN_MAP_RESOLUTION && msg.height != 0 && msg.width != 0;
}

inline bool validateMsg(const nav_msgs::msg::OccupancyGrid& msg) {
  return validateMsg(msg.header) && validateMsg(msg.info) && msg.info.width <= INT16_MAX &&
         msg.info.height <= INT16_MAX &&
         msg.data.size() == static_cast<size_t>(msg.info.width) * msg.info.height;
}

}  // namespace nav2_util
