// Velocities of one axis, evenly spaced between the least and the greatest that can be reached.
#pragma once

#include <algorithm>
#include <cmath>

namespace dwb_plugins {

const double EPSILON = 1E-5;

/// After `dt` seconds on the way from `v0` to the target. `decel` is negative.
inline double projectVelocity(double v0, double accel, double decel, double dt, double target) {
  if (v0 < target) return std::min(target, v0 + accel * dt);
  return std::max(target, v0 + decel * dt);
}

/// From the least to the greatest, and 0 between the last negative and the first positive one.
class OneDVelocityIterator {
 public:
  /// At least two samples, unless both ends are one.
  OneDVelocityIterator(double current, double min, double max, double acc_limit, double decel_limit,
                       double acc_time, int num_samples) {
    // Not std::clamp(), which wants min <= max.
    current = current < min ? min : (current > max ? max : current);
    max_vel_ = projectVelocity(current, acc_limit, decel_limit, acc_time, max);
    min_vel_ = projectVelocity(current, acc_limit, decel_limit, acc_time, min);
    reset();
    if (std::abs(min_vel_ - max_vel_) < EPSILON) return;
    increment_ = (max_vel_ - min_vel_) / (std::max(2, num_samples) - 1);
  }

  double getVelocity() const { return return_zero_now_ ? 0.0 : current_; }

  OneDVelocityIterator& operator++() {
    const double next = current_ + increment_;
    const bool passes_zero = current_ < 0.0 && next > 0.0 && next <= max_vel_ + EPSILON;
    return_zero_now_ = return_zero_ && passes_zero;
    if (return_zero_now_) {
      return_zero_ = false;
    } else {
      current_ = next;
    }
    return *this;
  }

  void reset() {
    current_ = min_vel_;
    return_zero_ = true;
    return_zero_now_ = false;
  }

  /// True for numbers that are not finite, too.
  bool isFinished() const { return !(current_ <= max_vel_ + EPSILON); }

 private:
  bool return_zero_ = true;       // 0 has not been returned yet
  bool return_zero_now_ = false;  // the current value is 0
  double min_vel_;
  double max_vel_;
  double current_ = 0.0;
  double increment_ = 1.0;
};

}  // namespace dwb_plugins
