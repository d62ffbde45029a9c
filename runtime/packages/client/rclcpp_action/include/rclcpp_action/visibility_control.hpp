// Everything is linked statically: the marks mean nothing.
#pragma once

#define RCLCPP_ACTION_EXPORT
#define RCLCPP_ACTION_IMPORT
#define RCLCPP_ACTION_PUBLIC
#define RCLCPP_ACTION_PUBLIC_TYPE
#define RCLCPP_ACTION_LOCAL
