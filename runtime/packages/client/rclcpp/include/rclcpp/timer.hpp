// Timers: a callback every so often, by any clock.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/context.hpp"
#include "rclcpp/detail/executable.hpp"
#include "rclcpp/function_traits.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

struct TimerInfo {
  Time expected_call_time;
  Time actual_call_time;
};

class TimerBase : public detail::Executable, public std::enable_shared_from_this<TimerBase> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(TimerBase)

  explicit TimerBase(Clock::SharedPtr clock, std::chrono::nanoseconds period,
                     rclcpp::Context::SharedPtr context, bool autostart = true);
  ~TimerBase() override;

  void cancel();
  bool is_canceled();
  /// Starts the period anew, also of a cancelled timer.
  void reset();
  /// Notes that the timer fires now. What it returns goes to execute_callback; null: cancelled.
  virtual std::shared_ptr<void> call();
  virtual void execute_callback(const std::shared_ptr<void>& data) = 0;
  /// nanoseconds::max() when cancelled; negative when overdue.
  std::chrono::nanoseconds time_until_trigger();
  virtual bool is_steady();
  bool is_ready();
  bool exchange_in_use_by_wait_set_state(bool in_use_state);
  /// Called with the number of resets, at once for those that nobody was told of.
  void set_on_reset_callback(std::function<void(size_t)> callback);
  void clear_on_reset_callback();
  /// The clock that the timer goes by.
  Clock::SharedPtr get_clock() const { return clock_; }

  bool polls() const override { return true; }
  bool is_ready_now() override { return is_ready(); }
  bool claim(std::shared_ptr<void>& data) override;
  bool run(std::shared_ptr<void>& data) override;

 protected:
  TimerInfo info_of(const std::shared_ptr<void>& data) const;

  Clock::SharedPtr clock_;

 private:
  RCLCPP_DISABLE_COPY(TimerBase)
  void on_jump(const rcl_time_jump_t& jump);

  std::recursive_mutex mutex_;
  int64_t period_ns_;
  int64_t last_call_ns_;
  int64_t next_call_ns_;
  bool canceled_;
  std::function<void(size_t)> on_reset_callback_;
  size_t untold_resets_ = 0;
  JumpHandler::SharedPtr jump_handler_;
  std::atomic<bool> in_use_by_wait_set_{false};
};

using VoidCallbackType = std::function<void()>;
using TimerCallbackType = std::function<void(TimerBase&)>;
using TimerInfoCallbackType = std::function<void(const TimerInfo&)>;

template <typename FunctorT, typename = void>
class GenericTimer : public TimerBase {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)

  explicit GenericTimer(Clock::SharedPtr clock, std::chrono::nanoseconds period,
                        FunctorT&& callback, rclcpp::Context::SharedPtr context,
                        bool autostart = true)
      : TimerBase(std::move(clock), period, std::move(context), autostart),
        callback_(std::forward<FunctorT>(callback)) {}

  ~GenericTimer() override { this->cancel(); }

  void execute_callback(const std::shared_ptr<void>& data) override {
    if constexpr (std::is_invocable_v<FunctorT&>) {
      callback_();
    } else if constexpr (std::is_invocable_v<FunctorT&, TimerBase&>) {
      callback_(*this);
    } else {
      static_assert(std::is_invocable_v<FunctorT&, const TimerInfo&>,
                    "a timer callback takes nothing, a TimerBase& or a const TimerInfo&");
      callback_(this->info_of(data));
    }
  }

 protected:
  RCLCPP_DISABLE_COPY(GenericTimer)
  FunctorT callback_;
};

template <typename FunctorT, typename = void>
class WallTimer : public GenericTimer<FunctorT> {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)

  WallTimer(std::chrono::nanoseconds period, FunctorT&& callback,
            rclcpp::Context::SharedPtr context, bool autostart = true)
      : GenericTimer<FunctorT>(std::make_shared<Clock>(RCL_STEADY_TIME), period,
                               std::move(callback), std::move(context), autostart) {}

 protected:
  RCLCPP_DISABLE_COPY(WallTimer)
};

}  // namespace rclcpp
