// Whether a type can be published: a message, or one with an adapter.
#pragma once

#include "rclcpp/type_adapter.hpp"
#include "rosidl_runtime_cpp/traits.hpp"

namespace rclcpp {

template <typename T>
struct is_ros_compatible_type {
  static constexpr bool value = rosidl_generator_traits::is_message<T>::value ||
                                rclcpp::TypeAdapter<T>::is_specialized::value;
};

}  // namespace rclcpp
