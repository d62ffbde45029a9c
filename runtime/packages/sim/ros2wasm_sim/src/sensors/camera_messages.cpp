// See camera_messages.hpp.
#include "sensors/camera_messages.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#include "sensors/point_fields.hpp"

namespace ros2wasm_sim {
namespace {

constexpr float kInfinite = std::numeric_limits<float>::infinity();

void set_size(sensor_msgs::msg::Image& message, const Lens& lens, std::uint32_t pixel_bytes) {
  message.width = static_cast<std::uint32_t>(lens.width);
  message.height = static_cast<std::uint32_t>(lens.height);
  message.step = message.width * pixel_bytes;
  message.data.resize(std::size_t{message.step} * message.height);
}

}  // namespace

std::optional<std::string> encoding_of(const std::string& format) {
  if (format == "R8G8B8" || format == "RGB_INT8") return "rgb8";
  if (format == "B8G8R8" || format == "BGR_INT8") return "bgr8";
  if (format == "L8" || format == "L_INT8") return "mono8";
  return std::nullopt;
}

sensor_msgs::msg::Image image_message(const Picture& picture, const std::string& encoding) {
  sensor_msgs::msg::Image message;
  message.encoding = encoding;
  message.width = static_cast<std::uint32_t>(picture.width);
  message.height = static_cast<std::uint32_t>(picture.height);
  const std::size_t pixels = picture.rgb.size() / 3;
  if (encoding == "mono8") {
    message.step = message.width;
    message.data.resize(pixels);
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::uint8_t* rgb = &picture.rgb[3 * i];
      // The weights of ITU-R BT.601, in thousandths.
      message.data[i] =
          static_cast<std::uint8_t>((299 * rgb[0] + 587 * rgb[1] + 114 * rgb[2] + 500) / 1000);
    }
    return message;
  }
  message.step = 3 * message.width;
  message.data = picture.rgb;
  if (encoding == "bgr8")
    for (std::size_t i = 0; i < pixels; ++i)
      std::swap(message.data[3 * i], message.data[3 * i + 2]);
  return message;
}

sensor_msgs::msg::CompressedImage jpeg_message(const Picture& picture) {
  constexpr int kQuality = 95;
  sensor_msgs::msg::CompressedImage message;
  message.format = "rgb8; jpeg compressed bgr8";
  message.data = jpeg_of(picture, kQuality);
  return message;
}

sensor_msgs::msg::Image depth_message(const Camera& camera, double min, double max) {
  sensor_msgs::msg::Image message;
  message.encoding = "32FC1";
  set_size(message, camera.lens(), sizeof(float));
  std::uint8_t* at = message.data.data();
  for (int y = 0; y < camera.lens().height; ++y)
    for (int x = 0; x < camera.lens().width; ++x, at += sizeof(float)) {
      float depth = camera.depth(x, y);
      if (depth <= min) depth = -kInfinite;
      if (depth >= max) depth = kInfinite;
      std::memcpy(at, &depth, sizeof depth);
    }
  return message;
}

sensor_msgs::msg::CameraInfo info_message(const CameraSettings& settings, double cx, double cy,
                                          double baseline) {
  const Lens& lens = settings.lens;
  sensor_msgs::msg::CameraInfo message;
  message.width = static_cast<std::uint32_t>(lens.width);
  message.height = static_cast<std::uint32_t>(lens.height);
  message.distortion_model = "plumb_bob";
  message.d.assign(settings.distortion.begin(), settings.distortion.end());
  message.k = {lens.fx, 0, cx, 0, lens.fy, cy, 0, 0, 1};
  message.r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  message.p = {lens.fx, 0, cx, -lens.fx * baseline, 0, lens.fy, cy, 0, 0, 0, 1, 0};
  return message;
}

sensor_msgs::msg::PointCloud2 depth_cloud_message(const Camera& camera, CloudAxes axes, double min,
                                                  double max) {
  using sensor_msgs::msg::PointField;
  const Lens& lens = camera.lens();
  sensor_msgs::msg::PointCloud2 message;
  message.fields = {
      point_field("x", 0, PointField::FLOAT32), point_field("y", 4, PointField::FLOAT32),
      point_field("z", 8, PointField::FLOAT32), point_field("rgb", 16, PointField::FLOAT32)};
  const bool optical = axes == CloudAxes::kOptical;
  message.point_step = optical ? 32 : 24;
  message.width = static_cast<std::uint32_t>(lens.width);
  message.height = static_cast<std::uint32_t>(lens.height);
  message.row_step = message.point_step * message.width;
  message.data.resize(std::size_t{message.row_step} * message.height);
  message.is_dense = true;
  std::uint8_t* at = message.data.data();
  const std::uint8_t* rgb = camera.picture().rgb.data();
  for (int row = 0; row < lens.height; ++row)
    for (int column = 0; column < lens.width; ++column, at += message.point_step, rgb += 3) {
      const float depth = camera.depth(column, row);
      const auto right = static_cast<float>((column + 0.5 - lens.cx) / lens.fx) * depth;
      const auto down = static_cast<float>((row + 0.5 - lens.cy) / lens.fy) * depth;
      float point[3] = {optical ? right : depth, optical ? down : -right, optical ? depth : -down};
      if (depth <= min || depth >= max) {
        message.is_dense = false;
        const float outside = depth <= min ? -kInfinite : kInfinite;
        for (float& one : point) one = optical ? std::numeric_limits<float>::quiet_NaN() : outside;
      }
      std::memcpy(at, point, sizeof point);
      const std::uint8_t color[4] = {rgb[2], rgb[1], rgb[0], 0};
      std::memcpy(at + 16, color, sizeof color);
    }
  return message;
}

}  // namespace ros2wasm_sim
