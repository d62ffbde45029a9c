// Loops at a given rate.
#pragma once

#include <chrono>
#include <memory>

#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp {

class RateBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(RateBase)
  virtual ~RateBase() {}
  virtual bool sleep() = 0;
  virtual rcl_clock_type_t get_type() const = 0;
  virtual void reset() = 0;
};

/// The older rate, by a clock of the standard library; rclcpp::Rate takes its place.
template <class Clock = std::chrono::high_resolution_clock>
class GenericRate : public RateBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericRate)

  /// `rate` in Hz.
  explicit GenericRate(double rate)
      : GenericRate(std::chrono::duration_cast<std::chrono::nanoseconds>(
            std::chrono::duration<double>(1.0 / rate))) {}
  explicit GenericRate(std::chrono::nanoseconds period)
      : period_(period), last_interval_(Clock::now()) {}

  /// Sleeps until the period is over; false when it is over already.
  bool sleep() override {
    const auto now = Clock::now();
    auto next = last_interval_ + period_;
    // The clock went back.
    if (now < last_interval_) {
      next = now + period_;
    }
    last_interval_ += period_;
    if (next <= now) {
      if (now > next + period_) {
        last_interval_ = now + period_;
      }
      return false;
    }
    rclcpp::sleep_for(std::chrono::duration_cast<std::chrono::nanoseconds>(next - now));
    return true;
  }
  bool is_steady() const { return Clock::is_steady; }
  rcl_clock_type_t get_type() const override {
    return Clock::is_steady ? RCL_STEADY_TIME : RCL_SYSTEM_TIME;
  }
  void reset() override { last_interval_ = Clock::now(); }
  std::chrono::nanoseconds period() const { return period_; }

 private:
  RCLCPP_DISABLE_COPY(GenericRate)
  std::chrono::nanoseconds period_;
  std::chrono::time_point<Clock, std::chrono::nanoseconds> last_interval_;
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
