// Durations in nanoseconds, with the range checked.
#pragma once

#include <chrono>
#include <stdexcept>

namespace rcpputils {

template <typename DurationRepT, typename DurationT>
std::chrono::nanoseconds convert_to_nanoseconds(
    const std::chrono::duration<DurationRepT, DurationT>& time) {
  const auto as_double = std::chrono::duration<double, std::nano>(time).count();
  if (as_double > 9.2233720368547748e18 || as_double < -9.2233720368547748e18) {
    throw std::invalid_argument{"time is out of the range of std::chrono::nanoseconds"};
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(time);
}

}  // namespace rcpputils
