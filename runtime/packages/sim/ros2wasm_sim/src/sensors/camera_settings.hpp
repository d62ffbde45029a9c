// A camera as SDF describes it: `camera`, `depth_camera`, `rgbd_camera` and their kin.
#pragma once

#include <array>
#include <string>

#include "render/camera.hpp"
#include "sensors/noise.hpp"

namespace ros2wasm_sim {

struct CameraSettings {
  std::string name;  ///< of <camera>
  Pose pose;         ///< in the sensor
  Lens lens;
  std::string format = "R8G8B8";            ///< of SDF's <image>
  std::array<double, 5> distortion{};       ///< k1 k2 p1 p2 k3; it is published, not drawn
  double noise_mean = 0, noise_stddev = 0;  ///< of a channel, which reaches from 0 to 1
  std::string info_topic;                   ///< <camera_info_topic>, or empty
  std::string optical_frame;                ///< <optical_frame_id>, or empty
  bool triggered = false;  ///< it draws when a message comes on the trigger's topic
  std::string trigger_topic;
};

/// Reads each <camera> of the sensor: one, but for a `multicamera`. A picture is at most 4096
/// pixels wide and high and has four million pixels; throws std::runtime_error for a larger one, or
/// when there is no <camera>.
std::vector<CameraSettings> read_cameras(const Sensor& sensor);

/// Adds noise of a mean and a deviation to each pixel, the same to all its channels.
class PictureNoise {
 public:
  PictureNoise(const CameraSettings& settings, std::uint64_t seed, const std::string& name);

  void apply(Picture& picture);

 private:
  Random random_;
  /// Drawn once, as a picture needs hundreds of thousands; which one a pixel gets is drawn each
  /// time.
  std::vector<std::int16_t> values_;
};

}  // namespace ros2wasm_sim
