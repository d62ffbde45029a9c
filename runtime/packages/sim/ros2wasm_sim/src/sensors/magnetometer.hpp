// The magnetic field of the world in the frame of a sensor: `magnetometer`.
#pragma once

#include <string>

#include "sensors/axes_noise.hpp"
#include "sensors/mount.hpp"

namespace ros2wasm_sim {

class Magnetometer {
 public:
  /// `field`: of the world, in tesla.
  Magnetometer(const Sensor& sensor, Physics& physics, const std::string& model,
               const std::string& link, const Vector3& field, std::uint64_t seed)
      : mount_(sensor, physics, model, link),
        field_(field),
        random_(seed, model + "::" + link + "::" + sensor.name),
        noise_(AxesNoise::read(Parameters(sensor.xml).inside("magnetometer"), random_)) {}

  /// Tesla, along the axes of the sensor.
  Vector3 measure() {
    return noise_.apply(rotate(inverse(mount_.pose().orientation), field_), random_);
  }
  const AxesNoise& noise() const { return noise_; }

 private:
  Mount mount_;
  Vector3 field_;
  Random random_;
  AxesNoise noise_;
};

}  // namespace ros2wasm_sim
