// Everything is linked statically: the marks mean nothing.
#pragma once

#define RCLCPP_LIFECYCLE_EXPORT
#define RCLCPP_LIFECYCLE_IMPORT
#define RCLCPP_LIFECYCLE_PUBLIC
#define RCLCPP_LIFECYCLE_PUBLIC_TYPE
#define RCLCPP_LIFECYCLE_LOCAL
