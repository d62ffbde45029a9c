// Distances, and lengths of paths.
#pragma once

#include <cmath>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "nav_msgs/msg/path.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace nav2_util {
namespace geometry_utils {

/// `angle` in rad.
inline geometry_msgs::msg::Quaternion orientationAroundZAxis(double angle) {
  tf2::Quaternion orientation;
  orientation.setRPY(0, 0, angle);
  return tf2::toMsg(orientation);
}

inline double euclidean_distance(const geometry_msgs::msg::Point& pos1,
                                 const geometry_msgs::msg::Point& pos2, const bool is_3d = false) {
  const double flat = std::hypot(pos1.x - pos2.x, pos1.y - pos2.y);
  return is_3d ? std::hypot(flat, pos1.z - pos2.z) : flat;
}

inline double euclidean_distance(const geometry_msgs::msg::Pose& pos1,
                                 const geometry_msgs::msg::Pose& pos2, const bool is_3d = false) {
  return euclidean_distance(pos1.position, pos2.position, is_3d);
}

inline double euclidean_distance(const geometry_msgs::msg::PoseStamped& pos1,
                                 const geometry_msgs::msg::PoseStamped& pos2,
                                 const bool is_3d = false) {
  return euclidean_distance(pos1.pose, pos2.pose, is_3d);
}

inline double euclidean_distance(const geometry_msgs::msg::Pose2D& pos1,
                                 const geometry_msgs::msg::Pose2D& pos2) {
  return std::hypot(pos1.x - pos2.x, pos1.y - pos2.y);
}

/// The element with the least value; the last of several.
template <typename Iter, typename Getter>
inline Iter min_by(Iter begin, Iter end, Getter getCompareVal) {
  if (begin == end) return end;
  Iter least = begin;
  auto least_value = getCompareVal(*begin);
  while (++begin != end) {
    const auto value = getCompareVal(*begin);
    if (value <= least_value) {
      least_value = value;
      least = begin;
    }
  }
  return least;
}

/// The first element farther along the way than a distance [m]; the end when there is none.
template <typename Iter, typename Getter>
inline Iter first_after_integrated_distance(Iter begin, Iter end, Getter getCompareVal) {
  if (begin == end) return end;
  Getter distance = 0.0;
  for (Iter next = begin + 1; next != end; ++begin, ++next) {
    distance += euclidean_distance(*begin, *next);
    if (distance > getCompareVal) return next;
  }
  return end;
}

/// In metres, from the pose `start_index` on.
inline double calculate_path_length(const nav_msgs::msg::Path& path, size_t start_index = 0) {
  double length = 0.0;
  for (size_t i = start_index; i + 1 < path.poses.size(); ++i) {
    length += euclidean_distance(path.poses[i], path.poses[i + 1]);
  }
  return length;
}

}  // namespace geometry_utils
}  // namespace nav2_util
