// Clocks: system, steady, and ROS time, which follows /clock when use_sim_time is set.
#pragma once

#include <functional>
#include <memory>
#include <mutex>

#include "rcl/time.h"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

class TimeSource;

class JumpHandler {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(JumpHandler)

  using pre_callback_t = std::function<void()>;
  using post_callback_t = std::function<void(const rcl_time_jump_t&)>;

  JumpHandler(pre_callback_t pre_callback, post_callback_t post_callback,
              const rcl_jump_threshold_t& threshold);

  pre_callback_t pre_callback;
  post_callback_t post_callback;
  rcl_jump_threshold_t notice_threshold;
};

class Clock {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)

  /// Throws RCLError for a clock type that does not exist.
  explicit Clock(rcl_clock_type_t clock_type = RCL_SYSTEM_TIME);
  ~Clock();

  Time now() const;
  /// Blocks until this clock shows `until`. False when shut down, cancelled, or when the source
  /// of ROS time changed meanwhile. Throws std::runtime_error for another type of clock.
  bool sleep_until(Time until, Context::SharedPtr context = contexts::get_global_default_context());
  bool sleep_for(Duration rel_time,
                 Context::SharedPtr context = contexts::get_global_default_context());
  /// Whether the time is not zero.
  bool started();
  bool wait_until_started(Context::SharedPtr context = contexts::get_global_default_context());
  bool wait_until_started(
      const rclcpp::Duration& timeout,
      Context::SharedPtr context = contexts::get_global_default_context(),
      const rclcpp::Duration& wait_tick_ns = rclcpp::Duration(0, static_cast<uint32_t>(1e7)));
  /// Whether ROS time comes from /clock. Throws RCLError for other clocks.
  bool ros_time_is_active();
  void cancel_sleep_or_wait();
  rcl_clock_type_t get_clock_type() const noexcept;
  std::mutex& get_clock_mutex() noexcept;
  /// The callbacks live as long as the returned handler.
  JumpHandler::SharedPtr create_jump_callback(JumpHandler::pre_callback_t pre_callback,
                                              JumpHandler::post_callback_t post_callback,
                                              const rcl_jump_threshold_t& threshold);

 private:
  friend TimeSource;
  void set_ros_time_active(bool active);
  void set_ros_time(int64_t nanoseconds);
  bool wait_until(int64_t until_ns, const Context::SharedPtr& context);
  template <typename ChangeT>
  void jump(rcl_clock_change_t change, ChangeT&& apply);

  class Impl;
  std::shared_ptr<Impl> impl_;
};

}  // namespace rclcpp
