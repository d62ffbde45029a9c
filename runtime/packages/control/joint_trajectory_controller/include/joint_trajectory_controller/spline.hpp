// A point of a trajectory, and what lies between two of them. Knows nothing of ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace joint_trajectory_controller {

/// One value per joint, or none. Units are those of the joints: rad, rad/s, rad/s^2, N m; or m.
struct PathPoint {
  std::vector<double> positions;
  std::vector<double> velocities;
  std::vector<double> accelerations;
  std::vector<double> effort;
  int64_t from_start_ns = 0;
};

/// A trajectory that is asked for.
struct PathRequest {
  std::vector<std::string> joints;
  int64_t start_ns = 0;  ///< 0: now
  std::vector<PathPoint> points;
};

/// The state `so_far_s` after `a`, on the way to `b` that takes `between_s`: quintic when both have
/// velocities and accelerations, cubic with velocities, else linear. Effort is linear.
PathPoint interpolate(const PathPoint& a, const PathPoint& b, double so_far_s, double between_s);

/// Fills positions (and velocities) of `b` that are missing, from its derivatives and from `a`,
/// `between_s` before.
void deduce_from_derivatives(PathPoint& a, PathPoint& b, size_t joints, double between_s);

/// Moves positions of joints that wrap by whole turns, so that the way to `next` is the shortest.
void wrap_around(std::vector<double>& positions, const std::vector<double>& next,
                 const std::vector<bool>& wraps);

/// From `position` to `wanted`, the shorter way round for a joint that wraps.
double position_error(double wanted, double position, bool wraps);

}  // namespace joint_trajectory_controller
