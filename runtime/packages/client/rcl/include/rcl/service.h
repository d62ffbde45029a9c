// The name of a service; made by rclcpp alone.
#ifndef RCL__SERVICE_H_
#define RCL__SERVICE_H_

typedef struct rcl_service_impl_s rcl_service_impl_t;
typedef struct rcl_service_s {
  rcl_service_impl_t* impl;
} rcl_service_t;

#endif  // RCL__SERVICE_H_
