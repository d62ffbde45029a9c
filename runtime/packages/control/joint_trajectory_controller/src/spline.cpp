// See spline.hpp.
#include "joint_trajectory_controller/spline.hpp"

#include <array>
#include <cmath>

namespace joint_trajectory_controller {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A polynomial of the time: the coefficients from the constant on.
using Polynomial = std::array<double, 6>;

struct End {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

Polynomial linear(double from, double to, double t) {
  return {from, t != 0.0 ? (to - from) / t : 0.0};
}

Polynomial cubic(const End& a, const End& b, double t) {
  if (t == 0.0) return {a.position, a.velocity};
  const double way = b.position - a.position;
  return {a.position, a.velocity, (3.0 * way - (2.0 * a.velocity + b.velocity) * t) / (t * t),
          (-2.0 * way + (a.velocity + b.velocity) * t) / (t * t * t)};
}

Polynomial quintic(const End& a, const End& b, double t) {
  if (t == 0.0) return {a.position, a.velocity, a.acceleration / 2.0};
  const double t2 = t * t;
  const double way = b.position - a.position;
  return {
      a.position,
      a.velocity,
      a.acceleration / 2.0,
      (20.0 * way - (8.0 * b.velocity + 12.0 * a.velocity) * t -
       (3.0 * a.acceleration - b.acceleration) * t2) /
          (2.0 * t2 * t),
      (-30.0 * way + (14.0 * b.velocity + 16.0 * a.velocity) * t +
       (3.0 * a.acceleration - 2.0 * b.acceleration) * t2) /
          (2.0 * t2 * t2),
      (12.0 * way - 6.0 * (b.velocity + a.velocity) * t + (b.acceleration - a.acceleration) * t2) /
          (2.0 * t2 * t2 * t)};
}

/// The value and its first two derivatives at a time.
End at(const Polynomial& p, double t) {
  End value;
  for (int i = 5; i >= 0; --i) value.position = value.position * t + p[i];
  for (int i = 5; i >= 1; --i) value.velocity = value.velocity * t + i * p[i];
  for (int i = 5; i >= 2; --i) value.acceleration = value.acceleration * t + i * (i - 1) * p[i];
  return value;
}

End end_of(const PathPoint& point, size_t joint, bool has_acceleration) {
  return {point.positions[joint], point.velocities[joint],
          has_acceleration ? point.accelerations[joint] : 0.0};
}

double shortest_turn(double from, double to) {
  double turn = std::fmod(to - from, 2.0 * kPi);
  if (turn > kPi) turn -= 2.0 * kPi;
  if (turn < -kPi) turn += 2.0 * kPi;
  return turn;
}

}  // namespace

PathPoint interpolate(const PathPoint& a, const PathPoint& b, double so_far_s, double between_s) {
  const bool is_outside = so_far_s < 0.0 || so_far_s > between_s;
  const bool has_velocity = !is_outside && !a.velocities.empty() && !b.velocities.empty();
  const bool has_acceleration =
      has_velocity && !a.accelerations.empty() && !b.accelerations.empty();
  if (so_far_s > between_s) so_far_s = between_s;
  if (so_far_s < 0.0) so_far_s = 0.0;

  const size_t joints = a.positions.size();
  PathPoint point;
  point.effort.assign(joints, 0.0);
  for (size_t i = 0; i < joints; ++i) {
    Polynomial way{};
    if (has_acceleration) {
      way = quintic(end_of(a, i, true), end_of(b, i, true), between_s);
    } else if (has_velocity) {
      way = cubic(end_of(a, i, false), end_of(b, i, false), between_s);
    } else {
      way = linear(a.positions[i], b.positions[i], between_s);
    }
    const End now = at(way, so_far_s);
    point.positions.push_back(now.position);
    point.velocities.push_back(now.velocity);
    point.accelerations.push_back(now.acceleration);
    if (!a.effort.empty() && !b.effort.empty()) {
      point.effort[i] = at(linear(a.effort[i], b.effort[i], between_s), so_far_s).position;
    }
  }
  return point;
}

void deduce_from_derivatives(PathPoint& a, PathPoint& b, size_t joints, double between_s) {
  if (a.effort.empty()) a.effort.assign(joints, 0.0);
  if (b.effort.empty()) b.effort.assign(joints, 0.0);
  if (!b.positions.empty()) return;
  if (a.velocities.empty()) a.velocities.assign(joints, 0.0);
  if (b.velocities.empty()) {
    if (a.accelerations.empty()) a.accelerations.assign(joints, 0.0);
    for (size_t i = 0; i < joints; ++i) {
      const double mean = (a.accelerations[i] + b.accelerations[i]) / 2.0;
      b.velocities.push_back(a.velocities[i] + mean * between_s);
    }
  }
  for (size_t i = 0; i < joints; ++i) {
    const double mean = (a.velocities[i] + b.velocities[i]) / 2.0;
    b.positions.push_back(a.positions[i] + mean * between_s);
  }
}

void wrap_around(std::vector<double>& positions, const std::vector<double>& next,
                 const std::vector<bool>& wraps) {
  for (size_t i = 0; i < wraps.size() && i < next.size(); ++i) {
    if (!wraps[i]) continue;
    double turn = shortest_turn(positions[i], next[i]);
    // Half a turn is as far either way: the sign of the difference decides.
    if (std::abs(std::abs(turn) - kPi) < 1e-9) {
      turn = next[i] > positions[i] ? std::abs(turn) : -std::abs(turn);
    }
    positions[i] = next[i] - turn;
  }
}

double position_error(double wanted, double position, bool wraps) {
  return wraps ? shortest_turn(position, wanted) : wanted - position;
}

}  // namespace joint_trajectory_controller
