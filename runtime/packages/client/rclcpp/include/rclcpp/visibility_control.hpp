// Everything is linked statically: the marks stay, for code that uses them, and mean nothing.
#pragma once

#define RCLCPP_EXPORT
#define RCLCPP_IMPORT
#define RCLCPP_PUBLIC
#define RCLCPP_PUBLIC_TYPE
#define RCLCPP_LOCAL
