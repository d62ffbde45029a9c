// A message as its bytes on the wire: CDR with a 4-byte header.
#pragma once

#include "rcl/allocator.h"
#include "rcl/types.h"
#include "rclcpp/macros.hpp"
#include "rclcpp/visibility_control.hpp"

namespace rclcpp {

class SerializedMessage {
 public:
  RCLCPP_SMART_PTR_DEFINITIONS(SerializedMessage)

  explicit SerializedMessage(const rcl_allocator_t& allocator = rcl_get_default_allocator());
  explicit SerializedMessage(size_t initial_capacity,
                             const rcl_allocator_t& allocator = rcl_get_default_allocator());
  SerializedMessage(const SerializedMessage& other);
  explicit SerializedMessage(const rcl_serialized_message_t& other);
  SerializedMessage(SerializedMessage&& other);
  explicit SerializedMessage(rcl_serialized_message_t&& other);
  SerializedMessage& operator=(const SerializedMessage& other);
  SerializedMessage& operator=(const rcl_serialized_message_t& other);
  SerializedMessage& operator=(SerializedMessage&& other);
  SerializedMessage& operator=(rcl_serialized_message_t&& other);
  virtual ~SerializedMessage();

  rcl_serialized_message_t& get_rcl_serialized_message() { return message_; }
  const rcl_serialized_message_t& get_rcl_serialized_message() const { return message_; }
  size_t size() const { return message_.buffer_length; }
  size_t capacity() const { return message_.buffer_capacity; }
  void reserve(size_t capacity);
  /// The caller frees what it gets.
  rcl_serialized_message_t release_rcl_serialized_message();

 private:
  rcl_serialized_message_t message_;
};

}  // namespace rclcpp
