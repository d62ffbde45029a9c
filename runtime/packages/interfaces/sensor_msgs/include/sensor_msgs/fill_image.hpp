// Puts pixels into an image message, or empties it.
#pragma once

#include <cstring>
#include <string>

#include "sensor_msgs/image_encodings.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace sensor_msgs {

/// `data_arg` has `rows_arg` rows of `step_arg` bytes.
inline bool fillImage(msg::Image& image, const std::string& encoding_arg, uint32_t rows_arg,
                      uint32_t cols_arg, uint32_t step_arg, const void* data_arg) {
  image.encoding = encoding_arg;
  image.height = rows_arg;
  image.width = cols_arg;
  image.step = step_arg;
  image.is_bigendian = 0;
  const auto* begin = static_cast<const unsigned char*>(data_arg);
  image.data.assign(begin, begin + static_cast<size_t>(step_arg) * rows_arg);
  return true;
}
inline void clearImage(msg::Image& image) {
  image.data.resize(0);
}

}  // namespace sensor_msgs
