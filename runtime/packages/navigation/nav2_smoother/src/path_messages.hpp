// Between messages and points of paths.
#pragma once

#include <cstddef>
#include <functional>

#include "nav2_smoother/path_geometry.hpp"
#include "nav_msgs/msg/path.hpp"

namespace nav2_smoother {

[[nodiscard]] PathPoints points_of(const nav_msgs::msg::Path& path);
/// Positions and orientations into the poses from an index on.
void put_points(const PathPoints& points, nav_msgs::msg::Path& path, size_t start);

/// Calls a function with the points of each part that has more than `least` steps. What it makes of
/// them is put into the path, turned along it.
void smooth_parts(nav_msgs::msg::Path& path, size_t least,
                  const std::function<void(PathPoints&)>& smooth);

}  // namespace nav2_smoother
