// The ranges of a lidar as the messages of sensor_msgs.
#pragma once

#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/point_cloud2.hpp>
#include <sensor_msgs/msg/range.hpp>

#include <string>
#include <vector>

#include "sensors/lidar.hpp"

namespace ros2wasm_sim {

/// The row in the middle.
sensor_msgs::msg::LaserScan scan_message(const LidarSettings& settings,
                                         const std::vector<double>& ranges);

/// x, y, z and intensity of what was met; points that were not are left away.
sensor_msgs::msg::PointCloud2 dense_cloud_message(const LidarSettings& settings,
                                                  const std::vector<double>& ranges);

/// x, y, z, intensity and ring of all rays, a row of points for each ring.
sensor_msgs::msg::PointCloud2 organized_cloud_message(const LidarSettings& settings,
                                                      const std::vector<double>& ranges);

/// The nearest of all rays.
sensor_msgs::msg::Range range_message(const LidarSettings& settings,
                                      const std::vector<double>& ranges, bool is_ultrasound);

}  // namespace ros2wasm_sim
