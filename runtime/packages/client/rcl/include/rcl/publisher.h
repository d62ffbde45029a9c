// The name of a publisher; made by rclcpp alone.
#ifndef RCL__PUBLISHER_H_
#define RCL__PUBLISHER_H_

typedef struct rcl_publisher_impl_s rcl_publisher_impl_t;
typedef struct rcl_publisher_s {
  rcl_publisher_impl_t* impl;
} rcl_publisher_t;

#endif  // RCL__PUBLISHER_H_
