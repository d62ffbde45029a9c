// Paths as points: where a robot reverses, what smooths them, and where each point looks. Without
// ROS. Metres and radians.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace nav2_smoother {

struct PathPoint {
  double x;
  double y;
  double yaw;
};
using PathPoints = std::vector<PathPoint>;

/// Points from `start` to `end`, both included.
struct PointRange {
  size_t start;
  size_t end;
};

/// The parts between points where the robot reverses or turns on the spot. A point is the end of
/// one part and the start of the next.
[[nodiscard]] std::vector<PointRange> parts_of(const PathPoints& path);

/// Turns each point but the last to the next one. True: the robot drives this part backward, so
/// the points look the other way. Points that are less than 0.1 mm apart stay.
bool turn_along(PathPoints& path);

/// A filter of 7 points and second order over all but the first and the last point, which count as
/// often as points are missing beyond them.
void filter_savitzky_golay(PathPoints& path);

struct RelaxationSettings {
  double tolerance;  // m, the sum of all movements of a round that is small enough
  int most_rounds;
  double data_weight;    // pulls a point to where it was
  double smooth_weight;  // pulls a point to the middle of its neighbours
};

enum class Relaxation { done, too_many_rounds, blocked, late };

/// Moves all but the first and the last point until they rest. Otherwise the path has the points
/// of the last whole round.
[[nodiscard]] Relaxation relax(PathPoints& path, const RelaxationSettings& settings,
                               const std::function<bool(const PathPoint&)>& is_free,
                               const std::function<bool()>& is_late);

}  // namespace nav2_smoother
