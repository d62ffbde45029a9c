// See path_ops.hpp.
#include "nav_2d_utils/path_ops.hpp"

#include <cmath>

namespace nav_2d_utils {

namespace {

// A gap that would need more poses stays: such a path is broken.
constexpr double kMostSteps = 100'000;

}  // namespace

nav_2d_msgs::msg::Path2D adjustPlanResolution(const nav_2d_msgs::msg::Path2D& global_plan_in,
                                              double resolution) {
  nav_2d_msgs::msg::Path2D result;
  for (const auto& next : global_plan_in.poses) {
    if (!result.poses.empty()) {
      const geometry_msgs::msg::Pose2D last = result.poses.back();
      const double distance = std::hypot(next.x - last.x, next.y - last.y);
      const double steps = std::floor(distance / resolution) - 3;
      for (int i = 1; steps <= kMostSteps && i < steps; ++i) {
        geometry_msgs::msg::Pose2D between;
        between.x = last.x + i * (next.x - last.x) / steps;
        between.y = last.y + i * (next.y - last.y) / steps;
        between.theta = last.theta + i * (next.theta - last.theta) / steps;
        result.poses.push_back(between);
      }
    }
    result.poses.push_back(next);
  }
  return result;
}

}  // namespace nav_2d_utils
