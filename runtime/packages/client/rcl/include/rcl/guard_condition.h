// A flag that wakes whoever waits for it.
#ifndef RCL__GUARD_CONDITION_H_
#define RCL__GUARD_CONDITION_H_

#include <stdbool.h>

#include "rcl/allocator.h"
#include "rcl/context.h"
#include "rcl/macros.h"
#include "rcl/types.h"
#include "rcl/visibility_control.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct rcl_guard_condition_impl_s rcl_guard_condition_impl_t;

typedef struct rcl_guard_condition_s {
  rcl_context_t* context;
  rcl_guard_condition_impl_t* impl;
} rcl_guard_condition_t;

typedef struct rcl_guard_condition_options_s {
  rcl_allocator_t allocator;
} rcl_guard_condition_options_t;

RCL_PUBLIC RCL_WARN_UNUSED rcl_guard_condition_t rcl_get_zero_initialized_guard_condition(void);
/** RCL_RET_ALREADY_INIT, _INVALID_ARGUMENT or _BAD_ALLOC when it cannot be. */
RCL_PUBLIC RCL_WARN_UNUSED rcl_ret_t
rcl_guard_condition_init(rcl_guard_condition_t* guard_condition, rcl_context_t* context,
                         const rcl_guard_condition_options_t options);
RCL_PUBLIC RCL_WARN_UNUSED rcl_ret_t
rcl_guard_condition_fini(rcl_guard_condition_t* guard_condition);
RCL_PUBLIC RCL_WARN_UNUSED rcl_guard_condition_options_t
rcl_guard_condition_get_default_options(void);
/** May be called from any thread. */
RCL_PUBLIC RCL_WARN_UNUSED rcl_ret_t
rcl_trigger_guard_condition(rcl_guard_condition_t* guard_condition);
/** NULL when it is not initialised. */
RCL_PUBLIC RCL_WARN_UNUSED const rcl_guard_condition_options_t* rcl_guard_condition_get_options(
    const rcl_guard_condition_t* guard_condition);

/** Whether it was triggered since this was last asked: what a wait does. Not in ROS's rcl, where
 * the middleware keeps the flag. */
bool ros2wasm_rcl_take_trigger(const rcl_guard_condition_t* guard_condition);

#ifdef __cplusplus
}
#endif

#endif  // RCL__GUARD_CONDITION_H_
