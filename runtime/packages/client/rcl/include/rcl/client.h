// The name of a client, which rclcpp alone makes, and what one is asked for with.
#ifndef RCL__CLIENT_H_
#define RCL__CLIENT_H_

#include "rcl/allocator.h"
#include "rmw/qos_profiles.h"

typedef struct rcl_client_impl_s rcl_client_impl_t;
typedef struct rcl_client_s {
  rcl_client_impl_t* impl;
} rcl_client_t;

typedef struct rcl_client_options_s {
  rmw_qos_profile_t qos;
  rcl_allocator_t allocator;
} rcl_client_options_t;

static inline rcl_client_options_t rcl_client_get_default_options(void) {
  rcl_client_options_t options = {rmw_qos_profile_services_default, rcl_get_default_allocator()};
  return options;
}

#endif  // RCL__CLIENT_H_
