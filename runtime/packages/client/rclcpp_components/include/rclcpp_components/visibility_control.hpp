// Everything is linked statically: the marks mean nothing.
#pragma once

#define RCLCPP_COMPONENTS_EXPORT
#define RCLCPP_COMPONENTS_IMPORT
#define RCLCPP_COMPONENTS_PUBLIC
#define RCLCPP_COMPONENTS_PUBLIC_TYPE
#define RCLCPP_COMPONENTS_LOCAL
