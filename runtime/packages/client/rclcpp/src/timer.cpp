// When timers fire: every period from their start, without catching up on what was missed.
#include "rclcpp/timer.hpp"

#include <limits>

#include "rclcpp/detail/listeners.hpp"
#include "ros2wasm/endpoint.hpp"

namespace rclcpp {
namespace {

struct CallInfo {
  int64_t expected_ns;
  int64_t actual_ns;
};

}  // namespace

TimerBase::TimerBase(Clock::SharedPtr clock, std::chrono::nanoseconds period,
                     rclcpp::Context::SharedPtr, bool autostart)
    : clock_(clock ? std::move(clock) : std::make_shared<Clock>(RCL_STEADY_TIME)),
      period_ns_(period.count()),
      last_call_ns_(clock_->now().nanoseconds()),
      next_call_ns_(last_call_ns_ + period_ns_),
      canceled_(!autostart) {
  if (clock_->get_clock_type() == RCL_ROS_TIME) {
    const rcl_jump_threshold_t every_jump{true, {1}, {-1}};
    jump_handler_ = clock_->create_jump_callback(
        nullptr, [this](const rcl_time_jump_t& jump) { on_jump(jump); }, every_jump);
  }
}

TimerBase::~TimerBase() = default;

void TimerBase::cancel() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  canceled_ = true;
}

bool TimerBase::is_canceled() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  return canceled_;
}

void TimerBase::reset() {
  {
    const std::lock_guard<std::recursive_mutex> lock(mutex_);
    next_call_ns_ = clock_->now().nanoseconds() + period_ns_;
    canceled_ = false;
    if (const auto callback = on_reset_callback_) {
      callback(1);
    } else {
      ++untold_resets_;
    }
  }
  ros2wasm::wake();
}

std::shared_ptr<void> TimerBase::call() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (canceled_) {
    return nullptr;
  }
  const int64_t now = clock_->now().nanoseconds();
  const int64_t expected = next_call_ns_;
  last_call_ns_ = now;
  next_call_ns_ += period_ns_;
  if (next_call_ns_ < now) {
    if (period_ns_ == 0) {
      next_call_ns_ = now;
    } else {
      next_call_ns_ += (1 + (now - next_call_ns_) / period_ns_) * period_ns_;
    }
  }
  return std::make_shared<CallInfo>(CallInfo{expected, now});
}

TimerInfo TimerBase::info_of(const std::shared_ptr<void>& data) const {
  const auto& info = *static_cast<const CallInfo*>(data.get());
  const rcl_clock_type_t type = clock_->get_clock_type();
  return {Time(info.expected_ns, type), Time(info.actual_ns, type)};
}

std::chrono::nanoseconds TimerBase::time_until_trigger() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (canceled_) {
    return std::chrono::nanoseconds::max();
  }
  return std::chrono::nanoseconds(next_call_ns_ - clock_->now().nanoseconds());
}

bool TimerBase::is_steady() {
  return clock_->get_clock_type() == RCL_STEADY_TIME;
}

bool TimerBase::is_ready() {
  return time_until_trigger().count() <= 0;
}

bool TimerBase::exchange_in_use_by_wait_set_state(bool in_use_state) {
  return in_use_by_wait_set_.exchange(in_use_state);
}

void TimerBase::set_on_reset_callback(std::function<void(size_t)> callback) {
  if (!callback) {
    throw std::invalid_argument("The callback passed to set_on_reset_callback is not callable.");
  }
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  on_reset_callback_ =
      detail::guarded<size_t>(this, "rclcpp::TimerBase", "on reset", std::move(callback));
  if (untold_resets_ > 0) {
    const auto told = on_reset_callback_;
    told(std::exchange(untold_resets_, 0));
  }
}

void TimerBase::clear_on_reset_callback() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  on_reset_callback_ = nullptr;
}

bool TimerBase::claim(std::shared_ptr<void>& data) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (!is_ready()) {
    return false;
  }
  data = call();
  return data != nullptr;
}

bool TimerBase::run(std::shared_ptr<void>& data) {
  execute_callback(data);
  return true;
}

void TimerBase::on_jump(const rcl_time_jump_t& jump) {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  const int64_t now = clock_->now().nanoseconds();
  const bool changed =
      jump.clock_change == RCL_ROS_TIME_ACTIVATED || jump.clock_change == RCL_ROS_TIME_DEACTIVATED;
  if (changed || now < last_call_ns_) {
    last_call_ns_ = now;
    next_call_ns_ = now + period_ns_;
  }
}

}  // namespace rclcpp
