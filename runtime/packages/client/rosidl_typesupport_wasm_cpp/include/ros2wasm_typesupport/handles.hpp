// Makes the callback tables and rosidl handles of a message or service from its Codec.
// Included by generated sources only.
#pragma once

#include <cstring>

#include "rosidl_runtime_c/message_type_support_struct.h"
#include "rosidl_runtime_c/service_type_support_struct.h"

#include "ros2wasm_typesupport/codec.hpp"
#include "ros2wasm_typesupport/message_callbacks.hpp"

namespace ros2wasm_typesupport {

template <class T>
void size_message(CdrSizer& sizer, const void* message) {
  size_value(sizer, *static_cast<const T*>(message));
}

template <class T>
void write_message(CdrWriter& writer, const void* message) {
  write_value(writer, *static_cast<const T*>(message));
}

template <class T>
void read_message(CdrReader& reader, void* message) {
  read_value(reader, *static_cast<T*>(message));
}

template <class T>
constexpr MessageCallbacks make_callbacks(const char* type_name, const char* type_hash,
                                          const TypeInfo& info) {
  return {type_name, type_hash, &size_message<T>, &write_message<T>, &read_message<T>, &info};
}

template <size_t kCount>
constexpr TypeInfo make_info(const char* type_name, const FieldInfo (&fields)[kCount],
                             const char* encoding, const char* source) {
  return {type_name, fields, kCount, encoding, source};
}

/// The `func` of a handle: the handle itself when it is of the kind asked for.
inline const rosidl_message_type_support_t* select_message_handle(
    const rosidl_message_type_support_t* handle, const char* identifier) {
  return std::strcmp(handle->typesupport_identifier, identifier) == 0 ? handle : nullptr;
}

inline const rosidl_service_type_support_t* select_service_handle(
    const rosidl_service_type_support_t* handle, const char* identifier) {
  return std::strcmp(handle->typesupport_identifier, identifier) == 0 ? handle : nullptr;
}

constexpr rosidl_message_type_support_t make_handle(const MessageCallbacks& callbacks) {
  return {kTypesupportIdentifier, &callbacks, &select_message_handle};
}

constexpr rosidl_service_type_support_t make_handle(const ServiceCallbacks& callbacks) {
  return {kTypesupportIdentifier, &callbacks, &select_service_handle};
}

}  // namespace ros2wasm_typesupport
