// Laser scans as clouds of points: where the laser stands, or in another frame while it moves.
#pragma once

#include <string>

#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "tf2/buffer_core.h"

namespace laser_geometry {
namespace channel_option {

/// The values of a point in addition to x, y and z; combined with `|`.
enum ChannelOption {
  None = 0x00,
  Intensity = 0x01,  ///< "intensity", where the scan has any
  Index = 0x02,      ///< "index": of the range in the scan, int32
  Distance = 0x04,   ///< "distances"
  Timestamp = 0x08,  ///< "stamps": seconds after the first
  Viewpoint = 0x10,  ///< "vp_x", "vp_y", "vp_z": where the laser was
  Default = (Intensity | Index)
};

}  // namespace channel_option

/// Ranges below the scan's least are skipped, and those from `range_cutoff` on (negative: the
/// scan's greatest).
class LaserProjection {
 public:
  void projectLaser(const sensor_msgs::msg::LaserScan& scan_in,
                    sensor_msgs::msg::PointCloud2& cloud_out, double range_cutoff = -1.0,
                    int channel_options = channel_option::Default) const;

  /// Each point at its own time: between the first range and the last the laser moves steadily.
  /// Throws what `tf` throws for these two times.
  void transformLaserScanToPointCloud(const std::string& target_frame,
                                      const sensor_msgs::msg::LaserScan& scan_in,
                                      sensor_msgs::msg::PointCloud2& cloud_out, tf2::BufferCore& tf,
                                      double range_cutoff = -1.0,
                                      int channel_options = channel_option::Default) const;
};

}  // namespace laser_geometry
