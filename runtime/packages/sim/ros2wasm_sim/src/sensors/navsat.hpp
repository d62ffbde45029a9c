// The measurements of a satellite receiver: `navsat` and `gps`.
#pragma once

#include <string>

#include "sensors/geographic.hpp"
#include "sensors/mount.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {

class NavSat {
 public:
  /// `heading` says which simulator the world is of: Gazebo Sim adds the noise of the horizontal
  /// position to the degrees, Gazebo Classic to the metres.
  NavSat(const Sensor& sensor, Physics& physics, const std::string& model, const std::string& link,
         const SphericalCoordinates& origin, Heading heading, std::uint64_t seed);

  Geographic position();
  /// m/s: east, north, up.
  Vector3 velocity();
  const Noise& horizontal_noise() const { return horizontal_; }
  const Noise& vertical_noise() const { return vertical_; }

 private:
  Mount mount_;
  TangentPlane plane_;
  Heading heading_;
  Random random_;
  Noise horizontal_, vertical_;              ///< of the position
  Noise horizontal_speed_, vertical_speed_;  ///< of the velocity
};

}  // namespace ros2wasm_sim
