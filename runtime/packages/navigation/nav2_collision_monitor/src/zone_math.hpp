// The geometry of zones and obstacles, without ROS. Lengths in metres, angles in radians.
#pragma once

#include <functional>
#include <vector>

#include "nav2_collision_monitor/types.hpp"

namespace nav2_collision_monitor {

/// Vertices in order, in either direction.
[[nodiscard]] bool is_inside(const std::vector<Point>& polygon, const Point& point);
[[nodiscard]] int count_inside(const std::vector<Point>& polygon, const std::vector<Point>& points);

/// How far ahead a robot's motion is simulated.
struct Forecast {
  double horizon;  // s
  double step;     // s
  int min_points;  // that make a collision
};

/// Returns the seconds until enough obstacles are in the zone of a robot that keeps its velocity:
/// 0 when they are in it now, -1 when that does not happen within the horizon.
[[nodiscard]] double time_to_collision(
    const std::vector<Point>& obstacles, Velocity velocity, const Forecast& forecast,
    const std::function<int(const std::vector<Point>&)>& count_in_zone);

/// The factor from 0 to 1 that brings a velocity below both limits and keeps its curvature.
[[nodiscard]] double limit_ratio(const Velocity& velocity, double linear_limit,
                                 double angular_limit);

/// The velocities for which a zone of a velocity polygon is meant.
struct SpeedRange {
  double linear_min;
  double linear_max;
  double theta_min;
  double theta_max;
  // Only for robots that move sideways, whose linear range is of the speed in this direction.
  double direction_end;
  double direction_start;
};
[[nodiscard]] bool is_in_range(const Velocity& velocity, const SpeedRange& range, bool holonomic);

/// Points at one distance over a field of view, `step` apart, and one at its end.
[[nodiscard]] std::vector<Point> arc_points(double distance, double field_of_view, double step);
/// Points along the closed outline, at most `distance` apart, with both ends of each edge.
[[nodiscard]] std::vector<Point> outline_points(const std::vector<Point>& polygon, double distance);

}  // namespace nav2_collision_monitor
