// The rays of a lidar: `ray`, `gpu_ray`, `lidar` and `gpu_lidar`.
#pragma once

#include <vector>

#include "physics/physics.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {

struct LidarSettings {
  int samples = 640;  ///< of a row
  int rows = 1;
  double min_angle = 0, max_angle = 0;                    ///< rad, counter-clockwise
  double vertical_min_angle = 0, vertical_max_angle = 0;  ///< rad, upwards
  double range_min = 0, range_max = kInfinity;            ///< metres
  double angle_increment() const {
    return samples > 1 ? (max_angle - min_angle) / (samples - 1) : 0;
  }
  double vertical_increment() const {
    return rows > 1 ? (vertical_max_angle - vertical_min_angle) / (rows - 1) : 0;
  }
};

class Lidar {
 public:
  /// `model` and `link` carry the sensor.
  Lidar(const Sensor& sensor, Physics& physics, const std::string& model, const std::string& link,
        std::uint64_t seed);

  const LidarSettings& settings() const { return settings_; }
  /// A row after the other, the lowest first: metres, +infinity where nothing is met within the
  /// range, -infinity where something is nearer than its minimum.
  const std::vector<double>& measure();

 private:
  void cast(const Pose& pose, double from);

  LidarSettings settings_;
  Pose pose_;  ///< in the link
  Physics& physics_;
  LinkHandle link_;
  RaySees sees_;
  Random random_;
  Noise noise_;
  std::vector<Vector3> directions_;  ///< in the frame of the sensor
  std::vector<Ray> rays_;
  std::vector<double> distances_;
  std::vector<double> ranges_;
};

}  // namespace ros2wasm_sim
