// The part of cameras that both simulators share: when they draw, and what.
#pragma once

#include <memory>
#include <string>

#include "plugins/plugin.hpp"
#include "sensors/camera_messages.hpp"

namespace ros2wasm_sim {

/// One camera of a sensor.
class CameraEye {
 public:
  CameraEye(const PluginContext& context, const CameraSettings& settings)
      : settings_(settings),
        camera_(settings.lens),
        noise_(settings, context.host.seed(),
               context.model->name + "::" + context.link->name + "::" + context.sensor->name +
                   "::" + settings.name),
        pose_(context.sensor->pose * settings.pose),
        link_(context.physics().link(context.model->name, context.link->name)),
        physics_(context.physics()),
        scene_(context.scene.of(context.simulation)) {
    const auto encoding = encoding_of(settings.format);
    const rclcpp::Logger logger = context.host.node()->get_logger();
    if (!encoding)
      RCLCPP_WARN(logger,
                  "camera [%s]: the format [%s] is not supported, it publishes R8G8B8 instead",
                  context.sensor->name.c_str(), settings.format.c_str());
    encoding_ = encoding.value_or("rgb8");
    for (const double one : settings.distortion)
      if (one != 0) {
        RCLCPP_WARN(logger,
                    "camera [%s]: its distortion is in its camera_info, but it is not drawn",
                    context.sensor->name.c_str());
        break;
      }
  }

  void draw() {
    camera_.draw(scene_, physics_.pose(link_) * pose_);
    picture_ = camera_.picture();
    noise_.apply(picture_);
  }
  void draw_depth() { camera_.draw_depth(scene_, physics_.pose(link_) * pose_); }

  const CameraSettings& settings() const { return settings_; }
  const Camera& camera() const { return camera_; }
  sensor_msgs::msg::Image image() const { return image_message(picture_, encoding_); }
  sensor_msgs::msg::CompressedImage jpeg() const { return jpeg_message(picture_); }

 private:
  CameraSettings settings_;
  Camera camera_;
  PictureNoise noise_;
  Picture picture_;  ///< with noise
  std::string encoding_;
  Pose pose_;  ///< in the link
  LinkHandle link_;
  Physics& physics_;
  RenderScene& scene_;
};

template <typename Publisher>
bool is_wanted(const Publisher& publisher) {
  return publisher != nullptr && publisher->get_subscription_count() > 0;
}

/// Publishes with a stamp and a frame.
template <typename Publisher, typename Message>
void publish_stamped(const Publisher& publisher, Message message, const Now& now,
                     const std::string& frame) {
  message.header.stamp = stamp_of(now.time_ns);
  message.header.frame_id = frame;
  publisher->publish(std::move(message));
}

}  // namespace ros2wasm_sim
