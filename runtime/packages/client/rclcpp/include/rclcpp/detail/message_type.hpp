// A message type as a few function pointers, so that the library's code exists once for all types.
#pragma once

#include "ros2wasm_typesupport/message_callbacks.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"
#include "rosidl_runtime_c/service_type_support_struct.h"
#include "rosidl_typesupport_cpp/message_type_support.hpp"
#include "rosidl_typesupport_cpp/service_type_support.hpp"

namespace rclcpp {
namespace detail {

using MessageCallbacks = ros2wasm_typesupport::MessageCallbacks;
using ServiceCallbacks = ros2wasm_typesupport::ServiceCallbacks;

inline const MessageCallbacks& callbacks_of(const rosidl_message_type_support_t& type_support) {
  return *static_cast<const MessageCallbacks*>(type_support.data);
}

inline const ServiceCallbacks& callbacks_of(const rosidl_service_type_support_t& type_support) {
  return *static_cast<const ServiceCallbacks*>(type_support.data);
}

template <typename MessageT>
const rosidl_message_type_support_t& type_support_of() {
  return *rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>();
}

/// How to copy and delete a message whose type is forgotten.
struct ObjectFunctions {
  void* (*copy)(const void* object);
  void (*destroy)(void* object);
};

template <typename T>
const ObjectFunctions& object_functions() {
  static constexpr ObjectFunctions functions{
      [](const void* object) -> void* { return new T(*static_cast<const T*>(object)); },
      [](void* object) { delete static_cast<T*>(object); }};
  return functions;
}

}  // namespace detail
}  // namespace rclcpp
