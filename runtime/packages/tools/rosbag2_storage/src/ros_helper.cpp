// Serialised messages on the heap.
#include "rosbag2_storage/ros_helper.hpp"

#include <cstring>
#include <stdexcept>
#include <string>

#include "rcutils/allocator.h"
#include "rcutils/error_handling.h"

namespace rosbag2_storage {

std::shared_ptr<rcutils_uint8_array_t> make_empty_serialized_message(size_t size) {
  auto message =
      std::make_unique<rcutils_uint8_array_t>(rcutils_get_zero_initialized_uint8_array());
  const rcutils_allocator_t allocator = rcutils_get_default_allocator();
  if (rcutils_uint8_array_init(message.get(), size, &allocator) != RCUTILS_RET_OK) {
    throw std::runtime_error(std::string("Error allocating resources for serialized message: ") +
                             rcutils_get_error_string().str);
  }
  return {message.release(), [](rcutils_uint8_array_t* one) {
            (void)rcutils_uint8_array_fini(one);
            delete one;
          }};
}

std::shared_ptr<rcutils_uint8_array_t> make_serialized_message(const void* data, size_t size) {
  auto message = make_empty_serialized_message(size);
  if (size != 0) {
    std::memcpy(message->buffer, data, size);
  }
  message->buffer_length = size;
  return message;
}

}  // namespace rosbag2_storage
