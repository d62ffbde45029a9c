// Rates.
#include "rclcpp/rate.hpp"

#include <stdexcept>

#include "rclcpp/context.hpp"
#include "rclcpp/contexts/default_context.hpp"

namespace rclcpp {
namespace {

Duration period_of(double rate) {
  if (rate <= 0.0) {
    throw std::invalid_argument{"rate must be greater than 0"};
  }
  return Duration::from_seconds(1.0 / rate);
}

}  // namespace

Rate::Rate(double rate, Clock::SharedPtr clock) : Rate(period_of(rate), std::move(clock)) {}

Rate::Rate(const Duration& period, Clock::SharedPtr clock)
    : clock_(std::move(clock)), period_(period), last_interval_(clock_->now()) {
  if (period <= Duration(0, 0)) {
    throw std::invalid_argument{"period must be greater than 0"};
  }
}

bool Rate::sleep() {
  const Time now = clock_->now();
  Time next_interval = last_interval_ + period_;
  if (now < last_interval_) {
    // Time went back.
    next_interval = now + period_;
  }
  last_interval_ += period_;
  if (next_interval <= now) {
    // A whole cycle was missed: begin anew from now.
    if (now > next_interval + period_) {
      last_interval_ = now + period_;
    }
    return false;
  }
  clock_->sleep_for(next_interval - now);
  return true;
}

rcl_clock_type_t Rate::get_type() const {
  return clock_->get_clock_type();
}

void Rate::reset() {
  last_interval_ = clock_->now();
}

std::chrono::nanoseconds Rate::period() const {
  return std::chrono::nanoseconds(period_.nanoseconds());
}

WallRate::WallRate(double rate) : Rate(rate, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
WallRate::WallRate(const Duration& period)
    : Rate(period, std::make_shared<Clock>(RCL_STEADY_TIME)) {}
ROSRate::ROSRate(double rate) : Rate(rate, std::make_shared<Clock>(RCL_ROS_TIME)) {}
ROSRate::ROSRate(const Duration& period) : Rate(period, std::make_shared<Clock>(RCL_ROS_TIME)) {}

}  // namespace rclcpp
