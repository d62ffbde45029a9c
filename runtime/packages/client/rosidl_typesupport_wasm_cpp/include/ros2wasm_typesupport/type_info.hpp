// Descriptions of the interface types that a program uses: names, fields, and the text that they
// were made from. Constant data; a program contains that of its own types only.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ros2wasm_typesupport {

struct TypeInfo;

/// As type_description_interfaces/msg/Field; null for a `nested` that is none.
struct FieldInfo {
  const char* name;
  const TypeInfo* nested;
  const char* default_value;
  uint32_t capacity;
  uint32_t string_capacity;
  uint8_t type_id;
};

struct TypeInfo {
  const char* type_name;
  const FieldInfo* fields;
  size_t field_count;
  /// "msg", "srv", "action" or "idl"; "implicit", without text, for a part of another type.
  const char* encoding;
  const char* source;
};

/// Every service's event has one; it comes with service_msgs.
extern const TypeInfo kType_service_msgs__msg__ServiceEventInfo;

}  // namespace ros2wasm_typesupport
