// Angles in radians: ranges, distances, distances within limits.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace angles {

inline double from_degrees(double degrees) {
  return degrees * M_PI / 180.0;
}
inline double to_degrees(double radians) {
  return radians * 180.0 / M_PI;
}

/// In [0, 2 pi).
inline double normalize_angle_positive(double angle) {
  const double rest = std::fmod(angle, 2.0 * M_PI);
  return rest < 0 ? rest + 2.0 * M_PI : rest;
}

/// In (-pi, pi].
inline double normalize_angle(double angle) {
  const double rest = std::fmod(angle + M_PI, 2.0 * M_PI);
  return rest <= 0 ? rest + M_PI : rest - M_PI;
}

/// In (-pi, pi]; added to `from` it gives `to`, up to full turns.
inline double shortest_angular_distance(double from, double to) {
  return normalize_angle(to - from);
}

/// The way to the same angle in the other direction, in [-2 pi, 2 pi].
inline double two_pi_complement(double angle) {
  const double turn = 2.0 * M_PI;
  const double rest = std::abs(angle) > turn ? std::fmod(angle, turn) : angle;
  return rest > 0 ? rest - turn : rest + turn;
}

/// How far one can turn from `from` (in [-pi, pi)) to the right (negative) and to the left until a
/// limit is met. False when `from` is not between the limits, which lie in [-pi, pi].
inline bool find_min_max_delta(double from, double left_limit, double right_limit,
                               double& result_min_delta, double& result_max_delta) {
  const double left = shortest_angular_distance(from, left_limit);
  const double right = shortest_angular_distance(from, right_limit);
  // Each limit is met in both directions: first the way back (negative), second the way ahead.
  const std::pair<double, double> to_left = std::minmax({left, two_pi_complement(left)});
  const std::pair<double, double> to_right = std::minmax({right, two_pi_complement(right)});
  if (left == 0) {
    result_min_delta = 0;
    result_max_delta = to_right.second;
    return true;
  }
  if (right == 0) {
    result_min_delta = to_left.first;
    result_max_delta = 0;
    return true;
  }
  if (to_left.first <= to_right.first || to_right.second >= to_left.second) {
    // The other limit comes first, so `from` is outside, unless everything is inside.
    result_min_delta = to_right.first;
    result_max_delta = to_left.second;
    return left_limit == -M_PI && right_limit == M_PI;
  }
  result_min_delta = to_left.first;
  result_max_delta = to_right.second;
  return true;
}

/// Limits may be beyond a turn, the left one must be less. True when `from` and the end of the way
/// are between them; else `shortest_angle` is the shortest way all the same.
inline bool shortest_angular_distance_with_large_limits(double from, double to, double left_limit,
                                                        double right_limit,
                                                        double& shortest_angle) {
  const auto is_inside = [&](double angle) { return left_limit <= angle && angle <= right_limit; };
  double near = shortest_angular_distance(from, to);
  double far = two_pi_complement(near);
  if (std::abs(near) > std::abs(far)) {
    std::swap(near, far);
  }
  shortest_angle = !is_inside(from + near) && is_inside(from + far) ? far : near;
  return left_limit <= right_limit && is_inside(from) && is_inside(from + shortest_angle);
}

/// Limits are in [-pi, pi]; with the left one above the right one they enclose pi. True when `from`
/// and `to` are between them; else `shortest_angle` is the way that leaves them least.
inline bool shortest_angular_distance_with_limits(double from, double to, double left_limit,
                                                  double right_limit, double& shortest_angle) {
  const double direct = shortest_angular_distance(from, to);
  const double other = two_pi_complement(direct);
  double min_delta = 0;
  double max_delta = 0;
  const bool is_inside = find_min_max_delta(from, left_limit, right_limit, min_delta, max_delta);
  if (is_inside) {
    for (const double way : {direct, other}) {
      if (min_delta <= way && way <= max_delta) {
        shortest_angle = way;
        return true;
      }
    }
    find_min_max_delta(to, left_limit, right_limit, min_delta, max_delta);
  }
  const double back = std::abs(min_delta);
  const double ahead = std::abs(max_delta);
  if (back == ahead) {
    shortest_angle = std::abs(direct) < std::abs(other) ? direct : other;
  } else {
    // Towards the nearer limit from outside; from inside, away from the limit that `to` is behind.
    shortest_angle =
        (back < ahead) == is_inside ? std::max(direct, other) : std::min(direct, other);
  }
  return false;
}

}  // namespace angles
