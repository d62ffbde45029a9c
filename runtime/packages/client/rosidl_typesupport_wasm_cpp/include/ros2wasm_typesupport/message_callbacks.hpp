// The target of a type support handle's `data`: the functions that turn one message type into CDR
// bytes and back. Depends on no client library and no transport.
#pragma once

#include <cstddef>
#include <cstdint>

#include "ros2wasm_typesupport/cdr.hpp"
#include "ros2wasm_typesupport/type_info.hpp"

namespace ros2wasm_typesupport {

/// `typesupport_identifier` of every handle made by rosidl_typesupport_wasm_cpp.
inline constexpr char kTypesupportIdentifier[] = "rosidl_typesupport_wasm_cpp";

/// Functions for one message type. The strings live as long as the program. The functions neither
/// throw (but for `std::bad_alloc`) nor keep pointers to their arguments.
struct MessageCallbacks {
  /// "std_msgs/msg/String", "example_interfaces/action/Fibonacci_SendGoal_Request".
  const char* type_name;
  /// "RIHS01_" and 64 hexadecimal digits.
  const char* type_hash;
  /// Null, as `info`, for a type that is known by its name only.
  void (*size)(CdrSizer& sizer, const void* message);
  void (*write)(CdrWriter& writer, const void* message);
  void (*read)(CdrReader& reader, void* message);
  const TypeInfo* info;

  /// Bytes of the whole buffer, the 4-byte CDR header included.
  [[nodiscard]] size_t serialized_size(const void* message) const {
    CdrSizer sizer;
    size(sizer, message);
    return sizer.total();
  }
  /// Writes header and payload, little-endian XCDR1. Returns the bytes written, or 0 when they did
  /// not fit or a bound of the type is exceeded.
  [[nodiscard]] size_t serialize(const void* message, uint8_t* buffer, size_t capacity) const {
    CdrWriter writer(buffer, capacity);
    write(writer, message);
    return writer.finish();
  }
  /// Reads a buffer of either byte order into a constructed message and overwrites all its fields.
  /// False for malformed input; the message is then valid, its fields are unspecified.
  [[nodiscard]] bool deserialize(const uint8_t* buffer, size_t buffer_size, void* message) const {
    CdrReader reader(buffer, buffer_size);
    if (reader.ok()) {
      read(reader, message);
    }
    return reader.ok();
  }
};

/// The two halves of a service, and what those who watch it are told.
struct ServiceCallbacks {
  /// "example_interfaces/srv/AddTwoInts".
  const char* type_name;
  const char* type_hash;
  const MessageCallbacks* request;
  const MessageCallbacks* response;
  const TypeInfo* info;
  const TypeInfo* event;
  const char* event_hash;
};

}  // namespace ros2wasm_typesupport
