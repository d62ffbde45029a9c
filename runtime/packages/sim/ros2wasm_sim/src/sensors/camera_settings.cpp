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
/// Values of noise, of which each row of a picture takes a part that begins at random.
constexpr std::size_t kValues = 65536;
constexpr std::size_t kMostWidth = 4096;

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
  values_.resize(kValues + kMostWidth);
  for (std::size_t i = 0; i < kValues; ++i)
    values_[i] = static_cast<std::int16_t>(std::lround(std::clamp(
        255 * (settings.noise_mean + settings.noise_stddev * random_.gaussian()), -255.0, 255.0)));
  std::copy_n(values_.begin(), kMostWidth, values_.begin() + kValues);
}

void PictureNoise::apply(Picture& picture) {
  if (values_.empty()) return;
  std::uint8_t* rgb = picture.rgb.data();
  for (int row = 0; row < picture.height; ++row) {
    const std::int16_t* noise = &values_[random_.bits() % kValues];
    for (int column = 0; column < picture.width; ++column, rgb += 3)
      for (int c = 0; c < 3; ++c)
        rgb[c] = static_cast<std::uint8_t>(std::clamp(rgb[c] + noise[column], 0, 255));
  }
}

}  // namespace ros2wasm_sim
