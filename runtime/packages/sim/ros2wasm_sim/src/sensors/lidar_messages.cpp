// See lidar_messages.hpp.
#include "sensors/lidar_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "sensors/point_fields.hpp"

namespace ros2wasm_sim {
namespace {

using sensor_msgs::msg::PointField;

void put(std::vector<std::uint8_t>& data, std::size_t at, float value) {
  std::memcpy(data.data() + at, &value, sizeof value);
}

/// Calls `use` with the row, and x, y and z of each ray.
template <typename Use>
void each_point(const LidarSettings& settings, const std::vector<double>& ranges, Use use) {
  for (int row = 0; row < settings.rows; ++row) {
    const double pitch = settings.vertical_min_angle + row * settings.vertical_increment();
    for (int i = 0; i < settings.samples; ++i) {
      const double yaw = settings.min_angle + i * settings.angle_increment();
      const double range = ranges[static_cast<std::size_t>(row) * settings.samples + i];
      // Infinite in each direction that the ray has a part in, as upstream's.
      use(row, range, static_cast<float>(range * std::cos(pitch) * std::cos(yaw)),
          static_cast<float>(range * std::cos(pitch) * std::sin(yaw)),
          static_cast<float>(range * std::sin(pitch)));
    }
  }
}

}  // namespace

sensor_msgs::msg::LaserScan scan_message(const LidarSettings& settings,
                                         const std::vector<double>& ranges) {
  sensor_msgs::msg::LaserScan message;
  message.angle_min = static_cast<float>(settings.min_angle);
  message.angle_max = static_cast<float>(settings.max_angle);
  message.angle_increment = static_cast<float>(settings.angle_increment());
  message.range_min = static_cast<float>(settings.range_min);
  message.range_max = static_cast<float>(settings.range_max);
  const auto first =
      ranges.begin() + static_cast<std::ptrdiff_t>(settings.rows / 2) * settings.samples;
  message.ranges.assign(first, first + settings.samples);
  message.intensities.assign(settings.samples, 0.0F);
  return message;
}

sensor_msgs::msg::PointCloud2 dense_cloud_message(const LidarSettings& settings,
                                                  const std::vector<double>& ranges) {
  sensor_msgs::msg::PointCloud2 message;
  message.fields = {
      point_field("x", 0, PointField::FLOAT32), point_field("y", 4, PointField::FLOAT32),
      point_field("z", 8, PointField::FLOAT32), point_field("intensity", 12, PointField::FLOAT32)};
  message.point_step = 16;
  message.height = 1;
  message.is_dense = true;
  each_point(settings, ranges, [&](int, double range, float x, float y, float z) {
    if (!std::isfinite(range)) return;
    const std::size_t at = message.data.size();
    message.data.resize(at + message.point_step);
    put(message.data, at, x);
    put(message.data, at + 4, y);
    put(message.data, at + 8, z);
  });
  message.width = static_cast<std::uint32_t>(message.data.size() / message.point_step);
  message.row_step = static_cast<std::uint32_t>(message.data.size());
  return message;
}

sensor_msgs::msg::PointCloud2 organized_cloud_message(const LidarSettings& settings,
                                                      const std::vector<double>& ranges) {
  sensor_msgs::msg::PointCloud2 message;
  message.fields = {
      point_field("x", 0, PointField::FLOAT32), point_field("y", 4, PointField::FLOAT32),
      point_field("z", 8, PointField::FLOAT32), point_field("intensity", 16, PointField::FLOAT32),
      point_field("ring", 20, PointField::UINT16)};
  message.point_step = 24;
  message.width = static_cast<std::uint32_t>(settings.samples);
  message.height = static_cast<std::uint32_t>(settings.rows);
  message.row_step = message.point_step * message.width;
  message.data.resize(static_cast<std::size_t>(message.row_step) * message.height);
  message.is_dense =
      std::all_of(ranges.begin(), ranges.end(), [](double range) { return std::isfinite(range); });
  std::size_t at = 0;
  each_point(settings, ranges, [&](int row, double, float x, float y, float z) {
    put(message.data, at, x);
    put(message.data, at + 4, y);
    put(message.data, at + 8, z);
    const auto ring = static_cast<std::uint16_t>(row);
    std::memcpy(message.data.data() + at + 20, &ring, sizeof ring);
    at += message.point_step;
  });
  return message;
}

sensor_msgs::msg::Range range_message(const LidarSettings& settings,
                                      const std::vector<double>& ranges, bool is_ultrasound) {
  sensor_msgs::msg::Range message;
  message.radiation_type =
      is_ultrasound ? sensor_msgs::msg::Range::ULTRASOUND : sensor_msgs::msg::Range::INFRARED;
  message.field_of_view =
      static_cast<float>(std::max(settings.max_angle - settings.min_angle,
                                  settings.vertical_max_angle - settings.vertical_min_angle));
  message.min_range = static_cast<float>(settings.range_min);
  message.max_range = static_cast<float>(settings.range_max);
  const auto nearest = std::min_element(ranges.begin(), ranges.end());
  message.range = nearest == ranges.end() ? std::numeric_limits<float>::infinity()
                                          : static_cast<float>(*nearest);
  return message;
}

}  // namespace ros2wasm_sim
