// A point of time on one kind of clock, in nanoseconds.
#pragma once

#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"
#include "rclcpp/duration.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

class Clock;

class Time {
 public:
  Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  explicit Time(int64_t nanoseconds = 0, rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  Time(const Time& rhs) = default;
  Time(const builtin_interfaces::msg::Time& time_msg,  // NOLINT: conversion wanted
       rcl_clock_type_t clock_type = RCL_ROS_TIME);
  explicit Time(const rcl_time_point_t& time_point);
  virtual ~Time() = default;

  operator builtin_interfaces::msg::Time() const;
  Time& operator=(const Time& rhs) = default;
  Time& operator=(const builtin_interfaces::msg::Time& time_msg);
  bool operator==(const Time& rhs) const;
  bool operator!=(const Time& rhs) const;
  bool operator<(const Time& rhs) const;
  bool operator<=(const Time& rhs) const;
  bool operator>=(const Time& rhs) const;
  bool operator>(const Time& rhs) const;
  Time operator+(const Duration& rhs) const;
  Duration operator-(const Time& rhs) const;
  Time operator-(const Duration& rhs) const;
  Time& operator+=(const Duration& rhs);
  Time& operator-=(const Duration& rhs);

  rcl_time_point_value_t nanoseconds() const { return time_.nanoseconds; }
  static Time max(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  double seconds() const;
  rcl_clock_type_t get_clock_type() const { return time_.clock_type; }

 private:
  rcl_time_point_t time_;
  friend Clock;
};

Time operator+(const Duration& lhs, const Time& rhs);

/// Seconds and nanoseconds of a message as a system_clock time point.
builtin_interfaces::msg::Time convert_rcl_time_to_sec_nanos(rcl_time_point_value_t nanoseconds);

}  // namespace rclcpp
