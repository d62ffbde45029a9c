// See parameter_checks.hpp.
#include "parameter_checks.hpp"

#include <algorithm>
#include <cmath>

namespace nav2_velocity_smoother {
namespace {

/// The period of the timer has at least one millisecond.
constexpr double kFastest = 1000.0;  // Hz
/// A time in nanoseconds has 63 bits.
constexpr double kLongest = 9.0e9;  // s

struct Sign {
  const char* name;
  int sign;
  const char* when_configured;
  const char* when_changed;
};
constexpr char kAccel[] =
    "Negative values set of acceleration! These should be positive to speed up!";
constexpr char kDecel[] =
    "Positive values set of deceleration! These should be negative to slow down!";
constexpr Sign kSigns[] = {
    {"max_velocity", 1, "Negative values set of max_velocities! These should be positive!",
     "Negative values set of max_velocity! These should be positive!"},
    {"min_velocity", -1, "Positive values set of min_velocities! These should be negative!",
     "Positive values set of min_velocity! These should be negative!"},
    {"max_accel", 1, kAccel, kAccel},
    {"max_decel", -1, kDecel, kDecel},
};

std::string wrong_size(const std::string& name, Moment moment) {
  if (moment == Moment::kChange) return "Invalid size of parameter " + name + ". Must be size 3";
  return "Invalid setting of kinematic and/or deadband limits! All limits must be size of 3 "
         "representing (x, y, theta).";
}

}  // namespace

std::string check_number(const std::string& name, double value) {
  if (name == "smoothing_frequency") {
    const bool fits = value > 0.0 && 1000.0 / value < kLongest && value <= kFastest;
    return fits ? "" : "smoothing_frequency must be greater than 0 and at most 1000 Hz";
  }
  const bool is_time = name == "velocity_timeout" || name == "odom_duration";
  if (is_time && !(std::abs(value) <= kLongest)) return name + " must be from -9e9 to 9e9 seconds";
  return "";
}

std::string check_axes(const std::string& name, const std::vector<double>& values, Moment moment) {
  if (values.size() != 3) return wrong_size(name, moment);
  const auto is_nan = [](double value) { return std::isnan(value); };
  if (std::any_of(values.begin(), values.end(), is_nan)) return name + " must not contain NaN";
  for (const Sign& one : kSigns) {
    const auto has_wrong_sign = [&one](double value) { return value * one.sign < 0.0; };
    if (name == one.name && std::any_of(values.begin(), values.end(), has_wrong_sign)) {
      return moment == Moment::kChange ? one.when_changed : one.when_configured;
    }
  }
  return "";
}

std::string check_feedback(const std::string& value) {
  if (value == "OPEN_LOOP" || value == "CLOSED_LOOP") return "";
  return "Invalid feedback_type, options are OPEN_LOOP and CLOSED_LOOP.";
}

}  // namespace nav2_velocity_smoother
