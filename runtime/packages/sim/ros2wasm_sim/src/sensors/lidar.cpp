// See lidar.hpp.
#include "sensors/lidar.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {
namespace {

/// Enough for the largest lidars of SDF files, and little enough to be computed.
constexpr int kMostRays = 200'000;

LidarSettings read(const Parameters& lidar) {
  LidarSettings settings;
  const Parameters across = lidar.inside("scan/horizontal"), up = lidar.inside("scan/vertical");
  const auto count = [](const Parameters& given, double otherwise) {
    const double samples = given.number("samples", otherwise) * given.number("resolution", 1);
    return static_cast<int>(std::clamp(samples, 1.0, static_cast<double>(kMostRays)));
  };
  settings.samples = count(across, 640);
  settings.rows = std::clamp(count(up, 1), 1, std::max(1, kMostRays / settings.samples));
  settings.min_angle = across.number("min_angle", 0);
  settings.max_angle = across.number("max_angle", 0);
  settings.vertical_min_angle = up.number("min_angle", 0);
  settings.vertical_max_angle = up.number("max_angle", 0);
  const Parameters range = lidar.inside("range");
  settings.range_min = std::max(0.0, range.number("min", 0));
  settings.range_max = range.number("max", kInfinity);
  return settings;
}

}  // namespace

Lidar::Lidar(const Sensor& sensor, Physics& physics, const std::string& model,
             const std::string& link, std::uint64_t seed)
    : pose_(sensor.pose),
      physics_(physics),
      link_(physics.link(model, link)),
      // Gazebo renders the gpu kinds, so they see what is drawn.
      sees_(sensor.type == "ray" || sensor.type == "lidar" ? RaySees::kCollisions
                                                           : RaySees::kVisuals),
      random_(seed, model + "::" + link + "::" + sensor.name) {
  const Parameters all(sensor.xml);
  const Parameters lidar = all.has("lidar") ? all.inside("lidar") : all.inside("ray");
  settings_ = read(lidar);
  noise_ = Noise::read(sensor.xml, lidar.find("noise"), random_);
  for (int row = 0; row < settings_.rows; ++row)
    for (int i = 0; i < settings_.samples; ++i) {
      const double yaw = settings_.min_angle + i * settings_.angle_increment();
      const double pitch = settings_.vertical_min_angle + row * settings_.vertical_increment();
      directions_.push_back(
          {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)});
    }
}

void Lidar::cast(const Pose& pose, double from) {
  rays_.resize(directions_.size());
  for (std::size_t i = 0; i < directions_.size(); ++i) {
    const Vector3 direction = rotate(pose.orientation, directions_[i]);
    rays_[i] = {pose.position + from * direction, direction};
  }
}

const std::vector<double>& Lidar::measure() {
  const Pose pose = physics_.pose(link_) * pose_;
  // From the least range on, as the housing of the sensor may be around it.
  cast(pose, settings_.range_min);
  physics_.cast(rays_, sees_, {}, distances_);
  ranges_.resize(distances_.size());
  for (std::size_t i = 0; i < distances_.size(); ++i) {
    const double range = settings_.range_min + distances_[i];
    ranges_[i] =
        range >= settings_.range_max
            ? kInfinity
            : std::clamp(noise_.apply(range, random_), settings_.range_min, settings_.range_max);
  }
  if (settings_.range_min <= 0) return ranges_;
  // Nearer things count too, unless they are part of the link that carries the sensor. Mostly
  // nothing is near, so that one cast is enough.
  if (!physics_.is_near(pose.position, settings_.range_min, sees_, link_)) return ranges_;
  cast(pose, 0);
  physics_.cast(rays_, sees_, link_, distances_);
  for (std::size_t i = 0; i < distances_.size(); ++i)
    if (distances_[i] <= settings_.range_min) ranges_[i] = -kInfinity;
  return ranges_;
}

}  // namespace ros2wasm_sim
