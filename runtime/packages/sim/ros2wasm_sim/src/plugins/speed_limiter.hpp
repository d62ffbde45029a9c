// Limits of velocity, acceleration and jerk, one after the other, from the two commands before.
#pragma once

#include <algorithm>

#include "plugins/parameters.hpp"
#include "world/world.hpp"

namespace ros2wasm_sim {

class SpeedLimiter {
 public:
  /// `kind` is `linear` or `angular`. A value for the kind wins over the one for both.
  SpeedLimiter(const Parameters& given, const std::string& kind) {
    const auto read = [&](const std::string& bound, const std::string& what, double otherwise) {
      return given.number(bound + "_" + kind + "_" + what,
                          given.number(bound + "_" + what, otherwise));
    };
    min_velocity_ = read("min", "velocity", -kInfinity);
    max_velocity_ = read("max", "velocity", kInfinity);
    min_acceleration_ = read("min", "acceleration", -kInfinity);
    max_acceleration_ = read("max", "acceleration", kInfinity);
    min_jerk_ = read("min", "jerk", -kInfinity);
    max_jerk_ = read("max", "jerk", kInfinity);
  }

  double limit(double wanted, double seconds) {
    double value = wanted;
    if (seconds > 0) {
      const double change = value - last_, before = last_ - last_but_one_;
      value =
          last_ + before +
          std::clamp(change - before, min_jerk_ * seconds * seconds, max_jerk_ * seconds * seconds);
      value = last_ +
              std::clamp(value - last_, min_acceleration_ * seconds, max_acceleration_ * seconds);
    }
    value = std::clamp(value, min_velocity_, max_velocity_);
    last_but_one_ = last_;
    last_ = value;
    return value;
  }

  void reset() { last_ = last_but_one_ = 0; }

 private:
  double min_velocity_, max_velocity_, min_acceleration_, max_acceleration_, min_jerk_, max_jerk_;
  double last_ = 0, last_but_one_ = 0;
};

}  // namespace ros2wasm_sim
