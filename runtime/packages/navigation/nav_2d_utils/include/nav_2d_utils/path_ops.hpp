// Work on paths in the plane.
#pragma once

#include "nav_2d_msgs/msg/path2_d.hpp"

namespace nav_2d_utils {

/// Adds poses between those that are at least five resolutions [m] apart: as many as resolutions
/// fit between them, less four. The result has no header.
nav_2d_msgs::msg::Path2D adjustPlanResolution(const nav_2d_msgs::msg::Path2D& global_plan_in,
                                              double resolution);

}  // namespace nav_2d_utils
