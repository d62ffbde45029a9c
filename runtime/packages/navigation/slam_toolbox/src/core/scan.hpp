// A scan of a laser, in the frame of the base.
#pragma once

#include <cstdint>
#include <vector>

#include "core/planar.hpp"

namespace slam_toolbox {

struct Scan {
  int64_t time_ns = 0;
  Pose odometry;   ///< of the base, in the frame of odometry
  Pose corrected;  ///< of the base, in the map
  Point sensor;    ///< where the laser is mounted
  /// Where rays meet something, in the order of the readings.
  std::vector<Point> hits;
  uint32_t rays = 0;       ///< also those that meet nothing
  double max_range = 0.0;  ///< [m]: what is further away is matched, but is not drawn
  Point middle;            ///< the mean of the hits within the range, or the sensor

  /// The place that distances between scans are measured from.
  Point place(bool uses_middle) const { return corrected * (uses_middle ? middle : sensor); }
};

inline bool is_within_range(const Scan& scan, const Point& hit) {
  return squared_distance(scan.sensor, hit) < scan.max_range * scan.max_range;
}

/// Sets the mean of the hits.
inline void find_middle(Scan& scan) {
  scan.middle = scan.sensor;
  Point sum;
  double count = 0.0;
  for (const Point& hit : scan.hits) {
    if (!is_within_range(scan, hit)) continue;
    sum.x += hit.x;
    sum.y += hit.y;
    count += 1.0;
  }
  if (count > 0.0) scan.middle = {sum.x / count, sum.y / count};
}

}  // namespace slam_toolbox
