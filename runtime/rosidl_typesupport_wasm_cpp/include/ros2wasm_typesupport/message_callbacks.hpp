// What a type support handle's `data` points to: the functions that turn one message type into
// CDR bytes and back. Knows no client library and no transport.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ros2wasm_typesupport {

/// `typesupport_identifier` of every handle made by rosidl_typesupport_wasm_cpp.
inline constexpr char kTypesupportIdentifier[] = "rosidl_typesupport_wasm_cpp";

/// Functions for one message type. All pointers are set; the strings live as long as the program.
/// The functions neither throw (but for `std::bad_alloc`) nor keep pointers to their arguments.
struct MessageCallbacks {
  /// "std_msgs/msg/String", "example_interfaces/action/Fibonacci_SendGoal_Request".
  const char* type_name;
  /// "RIHS01_" and 64 hexadecimal digits.
  const char* type_hash;
  /// Bytes of the whole buffer, the 4-byte CDR header included.
  size_t (*serialized_size)(const void* message);
  /// Writes header and payload, little-endian XCDR1. Returns the bytes written, or 0 when they did
  /// not fit or a bound of the type is exceeded.
  size_t (*serialize)(const void* message, uint8_t* buffer, size_t capacity);
  /// Reads a buffer of either byte order into a constructed message and overwrites all its fields.
  /// False for malformed input; the message is then valid, its fields are unspecified.
  bool (*deserialize)(const uint8_t* buffer, size_t size, void* message);
};

/// Functions for the two halves of a service.
struct ServiceCallbacks {
  /// "example_interfaces/srv/AddTwoInts".
  const char* type_name;
  const char* type_hash;
  const MessageCallbacks* request;
  const MessageCallbacks* response;
};

}  // namespace ros2wasm_typesupport
