// Heights and what follows from them: `altimeter` and `air_pressure`.
#pragma once

#include <string>

#include "sensors/mount.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {

class Altimeter {
 public:
  /// Heights are above the present one.
  Altimeter(const Sensor& sensor, Physics& physics, const std::string& model,
            const std::string& link, std::uint64_t seed);

  double reference() const { return reference_; }  ///< metres
  double position();                               ///< metres above the reference
  double velocity();                               ///< m/s upwards

 private:
  Mount mount_;
  Random random_;
  Noise position_noise_, velocity_noise_;
  double reference_;
};

/// Pascals, of the standard atmosphere at a height in metres above the sea.
double standard_pressure(double height);

class AirPressure {
 public:
  AirPressure(const Sensor& sensor, Physics& physics, const std::string& model,
              const std::string& link, std::uint64_t seed);

  double measure();  ///< pascals
  double variance() const { return noise_.stddev() * noise_.stddev(); }

 private:
  Mount mount_;
  Random random_;
  Noise noise_;
  double reference_;  ///< metres above the sea of the world's height 0
};

}  // namespace ros2wasm_sim
