// Loops at a given rate.
#pragma once

#include <chrono>
#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp {

class RateBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(RateBase)
  virtual ~RateBase() {}
  virtual bool sleep() = 0;
  virtual rcl_clock_type_t get_type() const = 0;
  virtual void reset() = 0;
};

class Rate : public RateBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(Rate)

  /// `rate` in Hz. Throws std::invalid_argument unless it is positive.
  explicit Rate(double rate, Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));
  explicit Rate(const Duration& period,
                Clock::SharedPtr clock = std::make_shared<Clock>(RCL_SYSTEM_TIME));

  /// Sleeps until the period is over; false when it is over already.
  bool sleep() override;
  rcl_clock_type_t get_type() const override;
  void reset() override;
  std::chrono::nanoseconds period() const;

 private:
  RCLCPP_DISABLE_COPY(Rate)
  Clock::SharedPtr clock_;
  Duration period_;
  Time last_interval_;
};

class WallRate : public Rate {
 public:
  explicit WallRate(double rate);
  explicit WallRate(const Duration& period);
};

class ROSRate : public Rate {
 public:
  explicit ROSRate(double rate);
  explicit ROSRate(const Duration& period);
};

}  // namespace rclcpp
