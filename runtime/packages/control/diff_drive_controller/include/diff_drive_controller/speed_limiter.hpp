// Limits a speed, its acceleration and its jerk, by the names of the parameters.
#pragma once

#include "control_toolbox/rate_limiter.hpp"

namespace diff_drive_controller {

class SpeedLimiter {
 public:
  /// Units: m/s or rad/s, and per second and per second squared. NaN: see RateLimiter.
  explicit SpeedLimiter(double min_velocity, double max_velocity, double max_acceleration_reverse,
                        double max_acceleration, double max_deceleration,
                        double max_deceleration_reverse, double min_jerk, double max_jerk)
      : limiter_(min_velocity, max_velocity, max_acceleration_reverse, max_acceleration,
                 max_deceleration, max_deceleration_reverse, min_jerk, max_jerk) {}

  double limit(double& v, double v0, double v1, double dt) { return limiter_.limit(v, v0, v1, dt); }
  double limit_velocity(double& v) { return limiter_.limit_value(v); }
  double limit_acceleration(double& v, double v0, double dt) {
    return limiter_.limit_first_derivative(v, v0, dt);
  }
  double limit_jerk(double& v, double v0, double v1, double dt) {
    return limiter_.limit_second_derivative(v, v0, v1, dt);
  }

 private:
  control_toolbox::RateLimiter<double> limiter_;
};

}  // namespace diff_drive_controller
