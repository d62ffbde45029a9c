// See real_time.hpp.
#include "checks/real_time.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {
namespace {

constexpr std::int64_t kWindow = 5'000'000'000;
/// A program that was held for this long, as in a tab that is not shown, is not slow.
constexpr std::int64_t kLongest = 500'000'000;
constexpr double kEnough = 0.9;

struct Costs {
  int cameras = 0, lidars = 0, links = 0, meshes = 0;
  double pixels = 0, rays = 0;  ///< a second
};

bool is_camera(const std::string& type) {
  for (const char* name : {"camera", "depth", "rgbd", "multicamera"})
    if (type.find(name) != std::string::npos) return true;
  return false;
}

bool is_lidar(const std::string& type) {
  return type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar";
}

void add(const Sensor& sensor, Costs& costs) {
  constexpr double kRateByDefault = 30;  // Hz, for a sensor that measures as fast as it can
  const Parameters given(sensor.xml);
  const double rate = sensor.update_rate > 0 ? sensor.update_rate : kRateByDefault;
  if (is_camera(sensor.type)) {
    const Parameters image = given.inside("camera/image");
    ++costs.cameras;
    costs.pixels += image.number("width", 320) * image.number("height", 240) * rate;
  } else if (is_lidar(sensor.type)) {
    const Parameters scan = given.inside(given.has("ray") ? "ray/scan" : "lidar/scan");
    ++costs.lidars;
    costs.rays += scan.inside("horizontal").number("samples", 640) *
                  scan.inside("vertical").number("samples", 1) * rate;
  }
}

std::string counted(int count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

std::optional<double> RealTimeWatch::add(std::int64_t passed_ns, std::int64_t simulated_ns,
                                         double wanted) {
  if (has_said_ || wanted <= 0 || passed_ns > kLongest) {
    restart();
    return std::nullopt;
  }
  passed_ns_ += passed_ns;
  simulated_ns_ += simulated_ns;
  if (passed_ns_ < kWindow) return std::nullopt;
  const double factor = static_cast<double>(simulated_ns_) / static_cast<double>(passed_ns_);
  restart();
  if (factor >= kEnough * wanted) return std::nullopt;
  has_said_ = true;
  return factor;
}

std::string costs_of(const World& world) {
  Costs costs;
  for (const Model& model : world.models)
    for (const Link& link : model.links) {
      costs.links += model.is_static ? 0 : 1;
      for (const Sensor& sensor : link.sensors) add(sensor, costs);
      for (const Collision& collision : link.collisions)
        costs.meshes += std::holds_alternative<Mesh>(collision.geometry) ? 1 : 0;
    }
  return counted(costs.cameras, "camera") + " (" +
         std::to_string(std::lround(costs.pixels / 1000)) + "000 pixels a second), " +
         counted(costs.lidars, "lidar") + " (" + std::to_string(std::lround(costs.rays)) +
         " rays a second), " + counted(costs.links, "moving link") + ", " +
         counted(costs.meshes, "mesh collision");
}

}  // namespace ros2wasm_sim
