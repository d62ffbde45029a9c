// Serialised messages on the heap.
#pragma once

#include <cstddef>
#include <memory>

#include "rcutils/types/uint8_array.h"

namespace rosbag2_storage {

std::shared_ptr<rcutils_uint8_array_t> make_serialized_message(const void* data, size_t size);
/// With room for `size` bytes.
std::shared_ptr<rcutils_uint8_array_t> make_empty_serialized_message(size_t size);

}  // namespace rosbag2_storage
