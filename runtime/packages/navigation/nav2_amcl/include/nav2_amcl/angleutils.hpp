// Angles on the circle, in rad.
#pragma once

#include <cmath>

namespace nav2_amcl {

class angleutils {
 public:
  /// The same angle within [-pi, pi].
  static double normalize(double z) { return std::atan2(std::sin(z), std::cos(z)); }
  /// The shortest turn from `b` to `a`.
  static double angle_diff(double a, double b) {
    const double turn = normalize(a) - normalize(b);
    const double other_way = turn > 0 ? turn - 2 * M_PI : turn + 2 * M_PI;
    return std::abs(turn) < std::abs(other_way) ? turn : other_way;
  }
};

}  // namespace nav2_amcl
