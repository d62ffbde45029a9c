// A span of time in nanoseconds, signed.
#pragma once

#include <chrono>
#include <cstdint>

#include "builtin_interfaces/msg/duration.hpp"
#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"
#include "rclcpp/visibility_control.hpp"
#include "rmw/time.h"

namespace rclcpp {

class Duration {
 public:
  Duration(int32_t seconds, uint32_t nanoseconds);
  explicit Duration(std::chrono::nanoseconds nanoseconds);
  template <class Rep, class Period>
  Duration(const std::chrono::duration<Rep, Period>& duration)  // NOLINT: conversion wanted
      : Duration(std::chrono::duration_cast<std::chrono::nanoseconds>(duration)) {}
  Duration(const builtin_interfaces::msg::Duration& duration_msg);  // NOLINT: conversion wanted
  explicit Duration(const rcl_duration_t& duration);
  Duration(const Duration& rhs) = default;
  virtual ~Duration() = default;

  operator builtin_interfaces::msg::Duration() const;
  Duration& operator=(const Duration& rhs) = default;
  Duration& operator=(const builtin_interfaces::msg::Duration& duration_msg);
  bool operator==(const Duration& rhs) const;
  bool operator!=(const Duration& rhs) const;
  bool operator<(const Duration& rhs) const;
  bool operator<=(const Duration& rhs) const;
  bool operator>=(const Duration& rhs) const;
  bool operator>(const Duration& rhs) const;
  Duration operator+(const Duration& rhs) const;
  Duration& operator+=(const Duration& rhs);
  Duration operator-(const Duration& rhs) const;
  Duration& operator-=(const Duration& rhs);
  Duration operator*(double scale) const;
  Duration& operator*=(double scale);

  static Duration max();
  rcl_duration_value_t nanoseconds() const { return nanoseconds_; }
  double seconds() const;
  static Duration from_seconds(double seconds);
  static Duration from_nanoseconds(rcl_duration_value_t nanoseconds);
  static Duration from_rmw_time(rmw_time_t duration);
  template <class DurationT>
  DurationT to_chrono() const {
    return std::chrono::duration_cast<DurationT>(std::chrono::nanoseconds(nanoseconds_));
  }
  rmw_time_t to_rmw_time() const;

 private:
  Duration() = default;
  rcl_duration_value_t nanoseconds_ = 0;
};

/// Throws std::runtime_error for a time before 1970, std::overflow_error and std::underflow_error.
builtin_interfaces::msg::Time operator+(const builtin_interfaces::msg::Time& lhs,
                                        const Duration& rhs);
builtin_interfaces::msg::Time operator-(const builtin_interfaces::msg::Time& lhs,
                                        const Duration& rhs);

}  // namespace rclcpp
