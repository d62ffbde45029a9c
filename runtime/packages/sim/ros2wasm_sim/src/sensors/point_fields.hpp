// Fields of point clouds.
#pragma once

#include <sensor_msgs/msg/point_field.hpp>

namespace ros2wasm_sim {

/// One value a point, `offset` bytes after where the point begins.
inline sensor_msgs::msg::PointField point_field(const char* name, std::uint32_t offset,
                                                std::uint8_t type) {
  sensor_msgs::msg::PointField result;
  result.name = name;
  result.offset = offset;
  result.datatype = type;
  result.count = 1;
  return result;
}

}  // namespace ros2wasm_sim
