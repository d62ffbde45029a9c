// The controller of Gazebo: proportional, integral and derivative terms of an error.
#pragma once

#include <algorithm>
#include <cmath>

namespace ros2wasm_sim {

/// Limits hold only when the larger one is not below the smaller one.
struct PidSettings {
  double p = 0, i = 0, d = 0;
  double i_max = -1, i_min = 0;
  double command_max = -1, command_min = 0;
  double offset = 0;
};

class Pid {
 public:
  Pid() = default;
  explicit Pid(const PidSettings& settings) : settings_(settings) {}

  /// `error` is what is, less what is wanted; the command works against it.
  double update(double error, double seconds) {
    if (seconds <= 0 || !std::isfinite(error)) return 0;
    integral_ += settings_.i * seconds * error;
    if (settings_.i_max >= settings_.i_min)
      integral_ = std::clamp(integral_, settings_.i_min, settings_.i_max);
    const double rate = (error - last_error_) / seconds;
    last_error_ = error;
    const double command = settings_.offset - settings_.p * error - integral_ - settings_.d * rate;
    return settings_.command_max >= settings_.command_min
               ? std::clamp(command, settings_.command_min, settings_.command_max)
               : command;
  }

  void reset() { integral_ = last_error_ = 0; }

 private:
  PidSettings settings_;
  double integral_ = 0;  ///< with its gain
  double last_error_ = 0;
};

}  // namespace ros2wasm_sim
