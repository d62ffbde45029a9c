// The motion of a robot in small steps. Poses and velocities are any types with x, y and theta;
// knows nothing of ROS.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dwb_plugins {

/// Bounds what one trajectory can cost.
constexpr double kMostSteps = 10'000;

/// At least one. The greatest distances between poses are in m and rad.
template <class TwistT>
std::size_t count_steps(const TwistT& velocity, double sim_time, double linear_granularity,
                        double angular_granularity) {
  const double distance = std::hypot(velocity.x, velocity.y) * sim_time;
  const double angle = std::abs(velocity.theta) * sim_time;
  const double steps =
      std::ceil(std::max(distance / linear_granularity, angle / angular_granularity));
  return static_cast<std::size_t>(std::min(std::max(1.0, steps), kMostSteps));
}

/// After `dt` seconds straight on, turned at the end.
template <class PoseT, class TwistT>
PoseT moved(PoseT pose, const TwistT& velocity, double dt) {
  const double c = std::cos(pose.theta);
  const double s = std::sin(pose.theta);
  pose.x += (velocity.x * c - velocity.y * s) * dt;
  pose.y += (velocity.x * s + velocity.y * c) * dt;
  pose.theta += velocity.theta * dt;
  return pose;
}

}  // namespace dwb_plugins
