// See navsat.hpp.
#include "sensors/navsat.hpp"

#include <cmath>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {
namespace {

double within_half_turn(double degrees) {
  return std::remainder(degrees, 360);
}

}  // namespace

NavSat::NavSat(const Sensor& sensor, Physics& physics, const std::string& model,
               const std::string& link, const SphericalCoordinates& origin, Heading heading,
               std::uint64_t seed)
    : mount_(sensor, physics, model, link),
      plane_(origin, heading),
      heading_(heading),
      random_(seed, model + "::" + link + "::" + sensor.name) {
  const Parameters all(sensor.xml);
  const Parameters given = all.has("navsat") ? all.inside("navsat") : all.inside("gps");
  const auto noise = [&](const char* path) {
    const Parameters one = given.inside(path);
    return Noise::read(one.xml(), one.find("noise"), random_);
  };
  horizontal_ = noise("position_sensing/horizontal");
  vertical_ = noise("position_sensing/vertical");
  horizontal_speed_ = noise("velocity_sensing/horizontal");
  vertical_speed_ = noise("velocity_sensing/vertical");
}

Geographic NavSat::position() {
  Vector3 at = mount_.pose().position;
  if (heading_ == Heading::kClassic) {
    at.x = horizontal_.apply(at.x, random_);
    at.y = horizontal_.apply(at.y, random_);
    at.z = vertical_.apply(at.z, random_);
    return plane_.position(at);
  }
  Geographic result = plane_.position(at);
  result.latitude_deg = within_half_turn(horizontal_.apply(result.latitude_deg, random_));
  result.longitude_deg = within_half_turn(horizontal_.apply(result.longitude_deg, random_));
  result.altitude = vertical_.apply(result.altitude, random_);
  return result;
}

Vector3 NavSat::velocity() {
  Vector3 v = plane_.east_north_up(mount_.velocity());
  v.x = horizontal_speed_.apply(v.x, random_);
  v.y = horizontal_speed_.apply(v.y, random_);
  v.z = vertical_speed_.apply(v.z, random_);
  return v;
}

}  // namespace ros2wasm_sim
