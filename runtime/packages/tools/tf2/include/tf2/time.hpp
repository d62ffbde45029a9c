// Points in time and durations, in nanoseconds.
#pragma once

#include <chrono>
#include <string>

namespace tf2 {

using Duration = std::chrono::nanoseconds;
using TimePoint = std::chrono::time_point<std::chrono::system_clock, Duration>;
using IDuration = std::chrono::duration<int, std::nano>;

/// Asks a buffer for the latest that it has.
static const TimePoint TimePointZero = TimePoint(IDuration::zero());

TimePoint get_now();
Duration durationFromSec(double t_sec);
TimePoint timeFromSec(double t_sec);
double durationToSec(const Duration& input);
double timeToSec(const TimePoint& timepoint);
/// Seconds with six decimals.
std::string displayTimePoint(const TimePoint& stamp);

}  // namespace tf2
