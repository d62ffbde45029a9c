// Conversions of time.
#include "tf2/time.hpp"

#include <cmath>
#include <cstdio>

namespace tf2 {
namespace {

constexpr int64_t kSecond = 1000000000;

}  // namespace

TimePoint get_now() {
  return std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
}

Duration durationFromSec(double t_sec) {
  // Whole seconds apart, so that the rest keeps its precision.
  const double seconds = std::floor(t_sec);
  return Duration(static_cast<int64_t>(seconds) * kSecond + std::llround((t_sec - seconds) * 1e9));
}

TimePoint timeFromSec(double t_sec) {
  return TimePoint(durationFromSec(t_sec));
}

double durationToSec(const Duration& input) {
  return static_cast<double>(input.count() / kSecond) +
         1e-9 * static_cast<double>(input.count() % kSecond);
}

double timeToSec(const TimePoint& timepoint) {
  return durationToSec(timepoint.time_since_epoch());
}

std::string displayTimePoint(const TimePoint& stamp) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f", timeToSec(stamp));
  return text;
}

}  // namespace tf2
