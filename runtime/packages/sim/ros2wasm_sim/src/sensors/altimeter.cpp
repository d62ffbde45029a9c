// See altimeter.hpp.
#include "sensors/altimeter.hpp"

#include <cmath>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {
namespace {

Noise noise_of(const Sensor& sensor, const char* path, Random& random) {
  const Parameters given = Parameters(sensor.xml).inside(path);
  return Noise::read(given.xml(), given.find("noise"), random);
}

}  // namespace

Altimeter::Altimeter(const Sensor& sensor, Physics& physics, const std::string& model,
                     const std::string& link, std::uint64_t seed)
    : mount_(sensor, physics, model, link),
      random_(seed, model + "::" + link + "::" + sensor.name),
      position_noise_(noise_of(sensor, "altimeter/vertical_position", random_)),
      velocity_noise_(noise_of(sensor, "altimeter/vertical_velocity", random_)),
      reference_(mount_.pose().position.z) {}

double Altimeter::position() {
  return position_noise_.apply(mount_.pose().position.z - reference_, random_);
}

double Altimeter::velocity() {
  return velocity_noise_.apply(mount_.velocity().z, random_);
}

double standard_pressure(double height) {
  constexpr double kSeaLevelPressure = 101325.0;   // Pa
  constexpr double kSeaLevelTemperature = 288.15;  // K
  constexpr double kLapse = 0.0065;                // K/m
  constexpr double kEarthRadius = 6356766.0;       // m
  // Gravity times the mass of air, by the constant of gases: 9.80665 m/s^2, 28.9644 kg/kmol,
  // 8314.32 J/(kmol K).
  constexpr double kExponent = 9.80665 * 28.9644 / (8314.32 * kLapse);
  const double geopotential = kEarthRadius * height / (kEarthRadius + height);
  return kSeaLevelPressure * std::pow(1 - kLapse * geopotential / kSeaLevelTemperature, kExponent);
}

AirPressure::AirPressure(const Sensor& sensor, Physics& physics, const std::string& model,
                         const std::string& link, std::uint64_t seed)
    : mount_(sensor, physics, model, link),
      random_(seed, model + "::" + link + "::" + sensor.name),
      noise_(noise_of(sensor, "air_pressure/pressure", random_)),
      reference_(Parameters(sensor.xml).inside("air_pressure").number("reference_altitude", 0)) {}

double AirPressure::measure() {
  return noise_.apply(standard_pressure(reference_ + mount_.pose().position.z), random_);
}

}  // namespace ros2wasm_sim
