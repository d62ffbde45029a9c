// Serialized messages and serialization.
#include "rclcpp/serialized_message.hpp"

#include <cstring>
#include <utility>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/serialization.hpp"

namespace rclcpp {
namespace {

rcl_serialized_message_t make(size_t capacity, const rcl_allocator_t& allocator) {
  rcl_serialized_message_t message = rcutils_get_zero_initialized_uint8_array();
  const rcutils_ret_t result = rcutils_uint8_array_init(&message, capacity, &allocator);
  if (result != RCUTILS_RET_OK) {
    exceptions::throw_from_rcl_error(result);
  }
  return message;
}

rcl_serialized_message_t copy_of(const rcl_serialized_message_t& from) {
  const rcl_allocator_t allocator =
      rcutils_allocator_is_valid(&from.allocator) ? from.allocator : rcl_get_default_allocator();
  rcl_serialized_message_t message = make(from.buffer_capacity, allocator);
  if (from.buffer_length > 0) {
    std::memcpy(message.buffer, from.buffer, from.buffer_length);
  }
  message.buffer_length = from.buffer_length;
  return message;
}

void release(rcl_serialized_message_t& message) {
  if (message.buffer != nullptr) {
    const rcutils_ret_t result = rcutils_uint8_array_fini(&message);
    static_cast<void>(result);
  }
}

}  // namespace

SerializedMessage::SerializedMessage(const rcl_allocator_t& allocator)
    : SerializedMessage(0u, allocator) {}
SerializedMessage::SerializedMessage(size_t initial_capacity, const rcl_allocator_t& allocator)
    : message_(make(initial_capacity, allocator)) {}
SerializedMessage::SerializedMessage(const SerializedMessage& other)
    : SerializedMessage(other.message_) {}
SerializedMessage::SerializedMessage(const rcl_serialized_message_t& other)
    : message_(copy_of(other)) {}
SerializedMessage::SerializedMessage(SerializedMessage&& other)
    : SerializedMessage(std::move(other.message_)) {}
SerializedMessage::SerializedMessage(rcl_serialized_message_t&& other)
    : message_(std::exchange(other, rcutils_get_zero_initialized_uint8_array())) {}

SerializedMessage& SerializedMessage::operator=(const SerializedMessage& other) {
  return this == &other ? *this : *this = other.message_;
}
SerializedMessage& SerializedMessage::operator=(const rcl_serialized_message_t& other) {
  rcl_serialized_message_t copy = copy_of(other);
  release(message_);
  message_ = copy;
  return *this;
}
SerializedMessage& SerializedMessage::operator=(SerializedMessage&& other) {
  return this == &other ? *this : *this = std::move(other.message_);
}
SerializedMessage& SerializedMessage::operator=(rcl_serialized_message_t&& other) {
  release(message_);
  message_ = std::exchange(other, rcutils_get_zero_initialized_uint8_array());
  return *this;
}
SerializedMessage::~SerializedMessage() {
  release(message_);
}

void SerializedMessage::reserve(size_t capacity) {
  const rcutils_ret_t result = rcutils_uint8_array_resize(&message_, capacity);
  if (result != RCUTILS_RET_OK) {
    exceptions::throw_from_rcl_error(result);
  }
}

rcl_serialized_message_t SerializedMessage::release_rcl_serialized_message() {
  return std::exchange(message_, rcutils_get_zero_initialized_uint8_array());
}

SerializationBase::SerializationBase(const rosidl_message_type_support_t* type_support)
    : type_support_(type_support) {
  if (type_support == nullptr) {
    throw std::invalid_argument("Type support is nullpointer.");
  }
}

void SerializationBase::serialize_message(const void* ros_message,
                                          SerializedMessage* serialized_message) const {
  if (ros_message == nullptr || serialized_message == nullptr) {
    throw std::invalid_argument(ros_message == nullptr ? "ROS message is nullpointer."
                                                       : "Serialized message is nullpointer.");
  }
  const detail::MessageCallbacks& callbacks = detail::callbacks_of(*type_support_);
  const size_t size = callbacks.serialized_size(ros_message);
  rcl_serialized_message_t& bytes = serialized_message->get_rcl_serialized_message();
  if (bytes.buffer_capacity < size) {
    serialized_message->reserve(size);
  }
  bytes.buffer_length = callbacks.serialize(ros_message, bytes.buffer, bytes.buffer_capacity);
  if (bytes.buffer_length == 0) {
    rcutils_set_error_state("a field is longer than its bound", __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "Failed to serialize ROS message.");
  }
}

void SerializationBase::deserialize_message(const SerializedMessage* serialized_message,
                                            void* ros_message) const {
  if (ros_message == nullptr || serialized_message == nullptr) {
    throw std::invalid_argument(ros_message == nullptr ? "ROS message is nullpointer."
                                                       : "Serialized message is nullpointer.");
  }
  if (serialized_message->capacity() == 0) {
    throw std::invalid_argument("Wrongly initialized serialized message.");
  }
  if (serialized_message->size() == 0) {
    throw std::invalid_argument("Serialized message data is empty.");
  }
  const rcl_serialized_message_t& bytes = serialized_message->get_rcl_serialized_message();
  if (!detail::callbacks_of(*type_support_)
           .deserialize(bytes.buffer, bytes.buffer_length, ros_message)) {
    rcutils_set_error_state("the bytes are not such a message", __FILE__, __LINE__);
    exceptions::throw_from_rcl_error(RCL_RET_ERROR, "Failed to deserialize ROS message.");
  }
}

}  // namespace rclcpp
