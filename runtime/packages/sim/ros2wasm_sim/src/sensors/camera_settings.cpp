// See camera_settings.hpp.
#include "sensors/camera_settings.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {
namespace {

constexpr double kMostSide = 4096;
constexpr double kMostPixels = 4'000'000;

Lens read_lens(const Parameters& camera) {
  const Parameters image = camera.inside("image"), clip = camera.inside("clip");
  const double width = image.number("width", 320), height = image.number("height", 240);
  if (!(width >= 1 && height >= 1 && width <= kMostSide && height <= kMostSide &&
        width * height <= kMostPixels))
    throw std::runtime_error("a camera of " + std::to_string(std::lround(width)) + " x " +
                             std::to_string(std::lround(height)) +
                             " pixels cannot be simulated: at most 4096 a side and 4 million in "
                             "all");
  Lens lens;
  lens.width = static_cast<int>(width);
  lens.height = static_cast<int>(height);
  const double fov = std::clamp(camera.number("horizontal_fov", 1.047), 0.001, 3.1);
  lens.fx = lens.fy = lens.width / (2 * std::tan(fov / 2));
  lens.cx = lens.width / 2.0;
  lens.cy = lens.height / 2.0;
  const Parameters intrinsics = camera.inside("lens/intrinsics");
  const auto positive = [&](const char* name, double otherwise) {
    const double value = intrinsics.number(name, otherwise);
    return value > 0 ? value : otherwise;
  };
  lens.fx = positive("fx", lens.fx);
  lens.fy = positive("fy", lens.fy);
  lens.cx = intrinsics.number("cx", lens.cx);
  lens.cy = intrinsics.number("cy", lens.cy);
  const Parameters depth_clip = camera.inside("depth_camera/clip");
  lens.near = depth_clip.number("near", clip.number("near", 0.1));
  lens.far = depth_clip.number("far", clip.number("far", 100));
  lens.near = std::max(lens.near, 1e-3);
  lens.far = std::max(lens.far, 1.001 * lens.near);
  return lens;
}

/// x, y, z and the angles about these axes.
Pose read_pose(const std::string& text) {
  std::istringstream numbers(text);
  double v[6] = {};
  for (double& one : v) numbers >> one;
  return {{v[0], v[1], v[2]}, from_roll_pitch_yaw(v[3], v[4], v[5])};
}

CameraSettings read_camera(const Parameters& camera) {
  CameraSettings settings;
  if (const std::string* name = camera.xml().element->attribute("name")) settings.name = *name;
  settings.pose = read_pose(camera.text("pose", ""));
  settings.lens = read_lens(camera);
  settings.format = camera.inside("image").text("format", settings.format);
  const Parameters distortion = camera.inside("distortion");
  constexpr const char* kNames[] = {"k1", "k2", "p1", "p2", "k3"};
  for (std::size_t i = 0; i < settings.distortion.size(); ++i)
    settings.distortion[i] = distortion.number(kNames[i], 0);
  const Parameters noise = camera.inside("noise");
  if (noise.text("type", "gaussian").rfind("gaussian", 0) == 0) {
    settings.noise_mean = noise.number("mean", 0);
    settings.noise_stddev = std::max(0.0, noise.number("stddev", 0));
  }
  settings.info_topic = camera.text("camera_info_topic", "");
  settings.optical_frame = camera.text("optical_frame_id", "");
  settings.triggered = camera.flag("triggered", false);
  settings.trigger_topic = camera.text("trigger_topic", "");
  return settings;
}

}  // namespace

std::vector<CameraSettings> read_cameras(const Sensor& sensor) {
  std::vector<CameraSettings> cameras;
  for (const Parameters& one : Parameters(sensor.xml).each("camera"))
    cameras.push_back(read_camera(one));
  if (cameras.empty())
    throw std::runtime_error("sensor [" + sensor.name + "] of type [" + sensor.type +
                             "] has no <camera>");
  return cameras;
}

PictureNoise::PictureNoise(const CameraSettings& settings, std::uint64_t seed,
                           const std::string& name)
    : random_(seed, name) {
  if (settings.noise_mean == 0 && settings.noise_stddev == 0) return;
  constexpr std::size_t kValues = 65536;
  values_.resize(kValues);
  for (std::int16_t& value : values_)
    value = static_cast<std::int16_t>(std::lround(std::clamp(
        255 * (settings.noise_mean + settings.noise_stddev * random_.gaussian()), -255.0, 255.0)));
}

void PictureNoise::apply(Picture& picture) {
  if (values_.empty()) return;
  constexpr std::size_t kDrawn = 4;  // values from one number
  std::uint64_t bits = 0;
  const std::size_t pixels = picture.rgb.size() / 3;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (i % kDrawn == 0) bits = random_.bits();
    const int noise = values_[bits & 0xffff];
    bits >>= 16;
    for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
      picture.rgb[c] = static_cast<std::uint8_t>(std::clamp(picture.rgb[c] + noise, 0, 255));
  }
}

}  // namespace ros2wasm_sim
