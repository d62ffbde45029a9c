// Guard conditions: those of the C library, and a callback.
#include "rclcpp/guard_condition.hpp"

#include <stdexcept>
#include <utility>

#include "rclcpp/exceptions.hpp"

namespace rclcpp {

GuardCondition::GuardCondition(const rclcpp::Context::SharedPtr& context,
                               rcl_guard_condition_options_t guard_condition_options)
    : context_(context) {
  if (!context) {
    throw std::invalid_argument("context argument unexpectedly nullptr");
  }
  const rcl_ret_t result = rcl_guard_condition_init(
      &rcl_guard_condition_, context->get_rcl_context().get(), guard_condition_options);
  if (result != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(result, "failed to create guard condition");
  }
}

GuardCondition::~GuardCondition() {
  static_cast<void>(rcl_guard_condition_fini(&rcl_guard_condition_));
}

void GuardCondition::trigger() {
  const std::lock_guard<std::recursive_mutex> lock(callback_mutex_);
  if (on_trigger_callback_) {
    on_trigger_callback_(1);
  } else {
    ++unread_count_;
  }
  const rcl_ret_t result = rcl_trigger_guard_condition(&rcl_guard_condition_);
  if (result != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(result);
  }
}

void GuardCondition::add_to_wait_set(rcl_wait_set_t& wait_set) {
  const rcl_ret_t result =
      rcl_wait_set_add_guard_condition(&wait_set, &rcl_guard_condition_, nullptr);
  if (result != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(result, "failed to add guard condition to wait set");
  }
}

bool GuardCondition::exchange_in_use_by_wait_set_state(bool in_use_state) {
  return in_use_by_wait_set_.exchange(in_use_state);
}

void GuardCondition::set_on_trigger_callback(std::function<void(size_t)> callback) {
  const std::lock_guard<std::recursive_mutex> lock(callback_mutex_);
  on_trigger_callback_ = std::move(callback);
  if (on_trigger_callback_ && unread_count_ > 0) {
    on_trigger_callback_(std::exchange(unread_count_, 0));
  }
}

}  // namespace rclcpp
