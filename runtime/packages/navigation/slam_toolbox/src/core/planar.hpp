// Points and poses in the plane, in m and rad.
#pragma once

#include <cmath>

namespace slam_toolbox {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

struct Pose {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;

  Point position() const { return {x, y}; }
};

/// The same angle from -pi to pi.
inline double wrapped(double angle) {
  return std::remainder(angle, 2.0 * M_PI);
}

/// A point of the frame `pose`, in the frame that `pose` is given in.
inline Point operator*(const Pose& pose, const Point& point) {
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return {pose.x + c * point.x - s * point.y, pose.y + s * point.x + c * point.y};
}

inline Pose operator*(const Pose& pose, const Pose& inner) {
  const Point position = pose * inner.position();
  return {position.x, position.y, wrapped(pose.yaw + inner.yaw)};
}

inline Pose inverse(const Pose& pose) {
  const double c = std::cos(pose.yaw);
  const double s = std::sin(pose.yaw);
  return {-c * pose.x - s * pose.y, s * pose.x - c * pose.y, wrapped(-pose.yaw)};
}

/// Where no place on Earth is, so that coordinates stay exact enough for cells.
inline bool is_usable(const Pose& pose) {
  constexpr double kFarthest = 1e6;  // [m]
  return std::abs(pose.x) < kFarthest && std::abs(pose.y) < kFarthest && std::isfinite(pose.yaw);
}

inline double squared_distance(const Point& a, const Point& b) {
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

}  // namespace slam_toolbox
