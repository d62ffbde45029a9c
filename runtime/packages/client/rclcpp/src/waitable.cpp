// Waitables and the wait sets that they are asked with.
#include "rclcpp/waitable.hpp"

#include <stdexcept>
#include <string>

#include "rclcpp/exceptions.hpp"

namespace rclcpp {

void Waitable::add_to_wait_set(rcl_wait_set_t& wait_set) {
  add_to_wait_set(&wait_set);
}

void Waitable::add_to_wait_set(rcl_wait_set_t*) {
  throw std::runtime_error("waitable does not override add_to_wait_set");
}

bool Waitable::is_ready(const rcl_wait_set_t& wait_set) {
  rcl_wait_set_t copy = wait_set;
  return is_ready(&copy);
}

bool Waitable::is_ready(rcl_wait_set_t*) {
  throw std::runtime_error("waitable does not override is_ready");
}

std::shared_ptr<void> Waitable::take_data_by_entity_id(size_t) {
  throw std::runtime_error(
      "Custom waitables should override take_data_by_entity_id if they want to use it.");
}

void Waitable::set_on_ready_callback(std::function<void(size_t, int)>) {
  throw std::runtime_error(
      "Custom waitables should override set_on_ready_callback if they want to use it.");
}

void Waitable::clear_on_ready_callback() {
  throw std::runtime_error(
      "Custom waitables should override clear_on_ready_callback if they want to use it and make "
      "sure to call it on the waitable destructor.");
}

bool Waitable::is_ready_now() {
  if (was_ready_) {
    return true;
  }
  detail::RclWaitSet set;
  set.reserve(*this);
  set.clear();
  add_to_wait_set(set.handle);
  set.take_triggers();
  was_ready_ = is_ready(static_cast<const rcl_wait_set_t&>(set.handle));
  return was_ready_;
}

bool Waitable::claim(std::shared_ptr<void>& data) {
  if (!is_ready_now()) {
    return false;
  }
  was_ready_ = false;
  data = take_data();
  return true;
}

bool Waitable::run(std::shared_ptr<void>& data) {
  execute(data);
  return true;
}

namespace detail {
namespace {

void require_ok(rcl_ret_t result, const char* what) {
  if (result != RCL_RET_OK) {
    exceptions::throw_from_rcl_error(result, what);
  }
}

}  // namespace

RclWaitSet::RclWaitSet() : handle(rcl_get_zero_initialized_wait_set()) {
  require_ok(rcl_wait_set_init(&handle, 0, 0, 0, 0, 0, 0, nullptr, rcl_get_default_allocator()),
             "failed to create wait set");
}

RclWaitSet::~RclWaitSet() {
  static_cast<void>(rcl_wait_set_fini(&handle));
}

void RclWaitSet::reserve(Waitable& waitable) {
  subscriptions += waitable.get_number_of_ready_subscriptions();
  guard_conditions += waitable.get_number_of_ready_guard_conditions();
  timers += waitable.get_number_of_ready_timers();
  clients += waitable.get_number_of_ready_clients();
  services += waitable.get_number_of_ready_services();
  events += waitable.get_number_of_ready_events();
}

void RclWaitSet::clear() {
  require_ok(rcl_wait_set_resize(&handle, subscriptions, guard_conditions, timers, clients,
                                 services, events),
             "failed to resize wait set");
}

bool RclWaitSet::take_triggers() {
  bool any = false;
  for (size_t i = 0; i < handle.size_of_guard_conditions; ++i) {
    const rcl_guard_condition_t*& guard = handle.guard_conditions[i];
    if (ros2wasm_rcl_take_trigger(guard)) {
      any = true;
    } else {
      guard = nullptr;
    }
  }
  return any;
}

}  // namespace detail
}  // namespace rclcpp
