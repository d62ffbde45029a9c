// See path_messages.hpp and smoother_utils.hpp.
#include "path_messages.hpp"

#include "nav2_smoother/smoother_utils.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "tf2/utils.h"

namespace nav2_smoother {

PathPoints points_of(const nav_msgs::msg::Path& path) {
  PathPoints points;
  points.reserve(path.poses.size());
  for (const auto& stamped : path.poses) {
    const auto& pose = stamped.pose;
    points.push_back({pose.position.x, pose.position.y, tf2::getYaw(pose.orientation)});
  }
  return points;
}

void put_points(const PathPoints& points, nav_msgs::msg::Path& path, size_t start) {
  for (size_t i = 0; i < points.size(); ++i) {
    auto& pose = path.poses[start + i].pose;
    pose.position.x = points[i].x;
    pose.position.y = points[i].y;
    pose.orientation = nav2_util::geometry_utils::orientationAroundZAxis(points[i].yaw);
  }
}

void smooth_parts(nav_msgs::msg::Path& path, size_t least,
                  const std::function<void(PathPoints&)>& smooth) {
  const PathPoints points = points_of(path);
  for (const PointRange& range : parts_of(points)) {
    if (range.end - range.start <= least) continue;
    const auto begin = points.begin();
    PathPoints part(begin + static_cast<ptrdiff_t>(range.start),
                    begin + static_cast<ptrdiff_t>(range.end) + 1);
    smooth(part);
    turn_along(part);
    // The last pose of a part looks where it did.
    const auto last = path.poses[range.end].pose.orientation;
    put_points(part, path, range.start);
    path.poses[range.end].pose.orientation = last;
  }
}

}  // namespace nav2_smoother

namespace smoother_utils {

std::vector<PathSegment> findDirectionalPathSegments(const nav_msgs::msg::Path& path) {
  std::vector<PathSegment> segments;
  for (const auto& range : nav2_smoother::parts_of(nav2_smoother::points_of(path))) {
    segments.push_back(
        {static_cast<unsigned int>(range.start), static_cast<unsigned int>(range.end)});
  }
  return segments;
}

void updateApproximatePathOrientations(nav_msgs::msg::Path& path, bool& reversing_segment) {
  nav2_smoother::PathPoints points = nav2_smoother::points_of(path);
  reversing_segment = nav2_smoother::turn_along(points);
  if (points.empty()) return;
  const auto last = path.poses.back().pose.orientation;
  nav2_smoother::put_points(points, path, 0);
  path.poses.back().pose.orientation = last;
}

}  // namespace smoother_utils
