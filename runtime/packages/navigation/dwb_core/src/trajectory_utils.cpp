// See trajectory_utils.hpp.
#include "dwb_core/trajectory_utils.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "nav2_core/controller_exceptions.hpp"

namespace dwb_core {

namespace {

/// The times [s] of the poses that have one.
std::vector<double> times_of(const dwb_msgs::msg::Trajectory2D& trajectory, const char* caller) {
  std::vector<double> times;
  const size_t count = std::min(trajectory.poses.size(), trajectory.time_offsets.size());
  for (size_t i = 0; i < count; ++i) {
    times.push_back(trajectory.time_offsets[i].sec + trajectory.time_offsets[i].nanosec * 1e-9);
  }
  if (times.empty()) {
    throw nav2_core::InvalidPath("Cannot call " + std::string(caller) + " on empty trajectory.");
  }
  return times;
}

}  // namespace

const geometry_msgs::msg::Pose2D& getClosestPose(const dwb_msgs::msg::Trajectory2D& trajectory,
                                                 const double time_offset) {
  const std::vector<double> times = times_of(trajectory, "getClosestPose");
  const auto nearest = std::min_element(times.begin(), times.end(), [&](double a, double b) {
    return std::abs(a - time_offset) < std::abs(b - time_offset);
  });
  return trajectory.poses[static_cast<size_t>(nearest - times.begin())];
}

geometry_msgs::msg::Pose2D projectPose(const dwb_msgs::msg::Trajectory2D& trajectory,
                                       const double time_offset) {
  const std::vector<double> times = times_of(trajectory, "projectPose");
  const auto after = std::upper_bound(times.begin(), times.end(), time_offset);
  if (after == times.begin()) return trajectory.poses.front();
  if (after == times.end()) return trajectory.poses.back();
  const auto index = static_cast<size_t>(after - times.begin());
  const geometry_msgs::msg::Pose2D& from = trajectory.poses[index - 1];
  const geometry_msgs::msg::Pose2D& to = trajectory.poses[index];
  const double part = (time_offset - times[index - 1]) / (times[index] - times[index - 1]);
  geometry_msgs::msg::Pose2D result;
  result.x = from.x + part * (to.x - from.x);
  result.y = from.y + part * (to.y - from.y);
  result.theta = from.theta + part * (to.theta - from.theta);
  return result;
}

}  // namespace dwb_core
