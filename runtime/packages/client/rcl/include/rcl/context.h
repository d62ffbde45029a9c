// The context type of the C library. It is only a handle: rclcpp makes the contexts.
#ifndef RCL__CONTEXT_H_
#define RCL__CONTEXT_H_

#include "rcl/types.h"

typedef struct rcl_context_impl_s rcl_context_impl_t;
typedef struct rcl_context_s {
  rcl_context_impl_t* impl;
} rcl_context_t;

#endif  // RCL__CONTEXT_H_
