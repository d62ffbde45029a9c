// Pictures as files, without ROS.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace nav2_waypoint_follower {

/// The fields of a sensor_msgs/Image.
struct Photo {
  uint32_t width;
  uint32_t height;
  uint32_t step;  // bytes of a row
  std::string encoding;
  const std::vector<uint8_t>& data;
};

/// Empty for a format that photo_file() writes, otherwise an error that lists those.
std::string unsupported_format(const std::string& format);

/// The file of a picture: png, jpg, jpeg or bmp. Throws std::runtime_error for other formats, for
/// encodings other than mono8, rgb8, bgr8, rgba8 and bgra8, and for a picture without all its data.
std::string photo_file(const Photo& photo, const std::string& format);

}  // namespace nav2_waypoint_follower
