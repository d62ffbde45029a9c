// The name of a timer; made by rclcpp alone.
#ifndef RCL__TIMER_H_
#define RCL__TIMER_H_

typedef struct rcl_timer_impl_s rcl_timer_impl_t;
typedef struct rcl_timer_s {
  rcl_timer_impl_t* impl;
} rcl_timer_t;

#endif  // RCL__TIMER_H_
