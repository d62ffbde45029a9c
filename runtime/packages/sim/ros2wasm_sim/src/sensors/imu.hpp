// The measurements of an IMU: angular velocity, proper acceleration (+9.8 upwards at rest),
// orientation.
#pragma once

#include <sensor_msgs/msg/imu.hpp>

#include <string>

#include "physics/physics.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {

class Imu {
 public:
  Imu(const Sensor& sensor, Physics& physics, const std::string& model, const std::string& link,
      std::uint64_t seed);

  /// Orientations are then relative to the present one.
  void take_reference() { reference_ = inverse(physics_.pose(link_) * pose_).orientation; }
  /// In the frame of the sensor; the header is empty.
  sensor_msgs::msg::Imu measure();

 private:
  struct Axes {
    Noise x, y, z;
  };
  Axes read_axes(const Sensor& sensor, const char* kind);
  Vector3 noisy(const Vector3& v, const Axes& noise);

  Pose pose_;  ///< in the link
  Physics& physics_;
  LinkHandle link_;
  Random random_;
  Axes rate_noise_, acceleration_noise_;
  Quaternion reference_;
};

}  // namespace ros2wasm_sim
