// Guard conditions: a flag, and the wake-up of everyone who waits in this program.
#include "rcl/guard_condition.h"

#include <atomic>
#include <new>

#include "rcl/error_handling.h"
#include "ros2wasm/endpoint.hpp"

struct rcl_guard_condition_impl_s {
  rcl_guard_condition_options_t options;
  std::atomic<bool> triggered{false};
};

namespace {

rcl_ret_t refuse(const char* reason, rcl_ret_t code) {
  rcutils_set_error_state(reason, __FILE__, __LINE__);
  return code;
}

}  // namespace

extern "C" {

rcl_guard_condition_t rcl_get_zero_initialized_guard_condition(void) {
  return {nullptr, nullptr};
}

rcl_guard_condition_options_t rcl_guard_condition_get_default_options(void) {
  return {rcl_get_default_allocator()};
}

rcl_ret_t rcl_guard_condition_init(rcl_guard_condition_t* guard_condition, rcl_context_t* context,
                                   const rcl_guard_condition_options_t options) {
  if (guard_condition == nullptr) {
    return refuse("guard_condition argument is null", RCL_RET_INVALID_ARGUMENT);
  }
  if (guard_condition->impl != nullptr) {
    return refuse("guard_condition already initialized, or memory was unintialized",
                  RCL_RET_ALREADY_INIT);
  }
  if (!rcutils_allocator_is_valid(&options.allocator)) {
    return refuse("invalid allocator", RCL_RET_INVALID_ARGUMENT);
  }
  void* place =
      options.allocator.allocate(sizeof(rcl_guard_condition_impl_t), options.allocator.state);
  if (place == nullptr) {
    return refuse("allocating memory failed", RCL_RET_BAD_ALLOC);
  }
  guard_condition->context = context;
  guard_condition->impl = new (place) rcl_guard_condition_impl_t{options};
  return RCL_RET_OK;
}

rcl_ret_t rcl_guard_condition_fini(rcl_guard_condition_t* guard_condition) {
  if (guard_condition == nullptr) {
    return refuse("guard_condition argument is null", RCL_RET_INVALID_ARGUMENT);
  }
  if (guard_condition->impl != nullptr) {
    const rcl_allocator_t allocator = guard_condition->impl->options.allocator;
    guard_condition->impl->~rcl_guard_condition_impl_t();
    allocator.deallocate(guard_condition->impl, allocator.state);
    guard_condition->impl = nullptr;
  }
  return RCL_RET_OK;
}

rcl_ret_t rcl_trigger_guard_condition(rcl_guard_condition_t* guard_condition) {
  if (guard_condition == nullptr || guard_condition->impl == nullptr) {
    return refuse("guard condition is not initialized", RCL_RET_INVALID_ARGUMENT);
  }
  guard_condition->impl->triggered = true;
  ros2wasm::wake();
  return RCL_RET_OK;
}

const rcl_guard_condition_options_t* rcl_guard_condition_get_options(
    const rcl_guard_condition_t* guard_condition) {
  if (guard_condition == nullptr || guard_condition->impl == nullptr) {
    return nullptr;
  }
  return &guard_condition->impl->options;
}

bool ros2wasm_rcl_take_trigger(const rcl_guard_condition_t* guard_condition) {
  return guard_condition != nullptr && guard_condition->impl != nullptr &&
         guard_condition->impl->triggered.exchange(false);
}

}  // extern "C"
