// Between messages and their bytes.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "rclcpp/detail/message_type.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/visibility_control.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace rclcpp {

class SerializationBase {
 public:
  explicit SerializationBase(const rosidl_message_type_support_t* type_support);
  virtual ~SerializationBase() = default;
  /// Throws RCLError when the message cannot be written.
  void serialize_message(const void* ros_message, SerializedMessage* serialized_message) const;
  /// Throws RCLError for bytes that are not such a message.
  void deserialize_message(const SerializedMessage* serialized_message, void* ros_message) const;

 private:
  const rosidl_message_type_support_t* type_support_;
};

template <typename MessageT>
class Serialization : public SerializationBase {
 public:
  Serialization()
      : SerializationBase(rosidl_typesupport_cpp::get_message_type_support_handle<MessageT>()) {}
};

}  // namespace rclcpp
