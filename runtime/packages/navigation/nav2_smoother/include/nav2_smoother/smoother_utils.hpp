// Parts of a path and its orientations, for smoothers.
#pragma once

#include <vector>

#include "nav_msgs/msg/path.hpp"

namespace smoother_utils {

/// Indices of poses, both included.
struct PathSegment {
  unsigned int start;
  unsigned int end;
};

/// The parts between poses where the robot reverses or turns on the spot.
std::vector<PathSegment> findDirectionalPathSegments(const nav_msgs::msg::Path& path);

/// Turns the poses of a part along it. `reversing_segment`: the robot drives it backward.
void updateApproximatePathOrientations(nav_msgs::msg::Path& path, bool& reversing_segment);

}  // namespace smoother_utils
