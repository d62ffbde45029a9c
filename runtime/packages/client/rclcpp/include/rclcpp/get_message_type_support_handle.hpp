// The type support of a message, or of what an adapted type is sent as.
#pragma once

#include <type_traits>

#include "rclcpp/is_ros_compatible_type.hpp"
#include "rclcpp/type_adapter.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp {

template <typename MessageT>
const rosidl_message_type_support_t& get_message_type_support_handle() {
  static_assert(is_ros_compatible_type<MessageT>::value,
                "neither a message nor a type with a TypeAdapter");
  if constexpr (rosidl_generator_traits::is_message<MessageT>::value) {
    return *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>();
  } else {
    return *rosidl_typesupport_cpp::get_message_type_support_handle<
        typename TypeAdapter<MessageT>::ros_message_type>();
  }
}

}  // namespace rclcpp
