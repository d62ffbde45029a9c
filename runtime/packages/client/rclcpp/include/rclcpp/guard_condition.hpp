// A flag that wakes whoever waits for it.
#pragma once

#include <atomic>
#include <functional>
#include <mutex>

#include "rcl/guard_condition.h"
#include "rcl/wait.h"
#include "rclcpp/contexts/default_context.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

class GuardCondition {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(GuardCondition)

  /// Throws std::invalid_argument when the context is null.
  explicit GuardCondition(
      const rclcpp::Context::SharedPtr& context = contexts::get_global_default_context(),
      rcl_guard_condition_options_t guard_condition_options =
          rcl_guard_condition_get_default_options());
  virtual ~GuardCondition();

  rclcpp::Context::SharedPtr get_context() const { return context_; }
  rcl_guard_condition_t& get_rcl_guard_condition() { return rcl_guard_condition_; }
  const rcl_guard_condition_t& get_rcl_guard_condition() const { return rcl_guard_condition_; }
  /// May be called from any thread.
  void trigger();
  bool exchange_in_use_by_wait_set_state(bool in_use_state);
  /// Called with the number of triggers, now for those that were not taken.
  void set_on_trigger_callback(std::function<void(size_t)> callback);

  /// Throws RCLError when the wait set has no room.
  void add_to_wait_set(rcl_wait_set_t& wait_set);

 private:
  RCLCPP_DISABLE_COPY(GuardCondition)
  rclcpp::Context::SharedPtr context_;
  rcl_guard_condition_t rcl_guard_condition_{nullptr, nullptr};
  std::atomic<bool> in_use_by_wait_set_{false};
  std::recursive_mutex callback_mutex_;
  std::function<void(size_t)> on_trigger_callback_;
  size_t unread_count_ = 0;
};

}  // namespace rclcpp
