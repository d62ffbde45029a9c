// Cameras of Gazebo Sim: `camera`, `depth_camera` and `rgbd_camera`.
#include <std_msgs/msg/bool.hpp>

#include "plugins/camera_system.hpp"
#include "plugins/gz_topics.hpp"
#include "plugins/sensor_names.hpp"

namespace ros2wasm_sim {
namespace {

enum class Kind { kColor, kDepth, kBoth };

/// `a/b/what` in the place of `a/b/c`.
std::string beside(const std::string& topic, const std::string& what) {
  return topic.substr(0, topic.rfind('/') + 1) + what;
}

class GzCamera final : public System {
 public:
  GzCamera(const PluginContext& context, Kind kind)
      : eye_(context, read_cameras(*context.sensor).front()),
        rate_(whole_milliseconds(context.sensor->update_rate)) {
    const CameraSettings& settings = eye_.settings();
    frame_ = settings.optical_frame.empty() ? sensor_frame(context) : settings.optical_frame;
    const std::string topic = sensor_topic(context, kind == Kind::kColor   ? "/image"
                                                    : kind == Kind::kDepth ? "/depth_image"
                                                                           : "");
    std::string info = beside(topic, "camera_info");
    if (kind == Kind::kBoth) info = topic + "/camera_info";
    if (!settings.info_topic.empty()) info = settings.info_topic;
    Host& host = context.host;
    infos_ = publish_gz<sensor_msgs::msg::CameraInfo>(host, info);
    if (kind != Kind::kDepth)
      images_ =
          publish_gz<sensor_msgs::msg::Image>(host, kind == Kind::kBoth ? topic + "/image" : topic);
    if (kind != Kind::kColor) {
      depths_ = publish_gz<sensor_msgs::msg::Image>(
          host, kind == Kind::kBoth ? topic + "/depth_image" : topic);
      clouds_ = publish_gz<sensor_msgs::msg::PointCloud2>(host, topic + "/points");
    }
    info_ = info_message(settings, settings.lens.cx, settings.lens.cy, 0);
    if (settings.triggered) listen(host, topic);
  }

  void after_step(const Now& now) override {
    if (triggers_ != nullptr && !is_asked_) return;
    if (!rate_.due(now.time_ns)) return;
    is_asked_ = false;
    const bool wants_cloud = is_wanted(clouds_), wants_depth = is_wanted(depths_);
    if (is_wanted(infos_)) publish_stamped(infos_, info_, now, frame_);
    if (is_wanted(images_) || wants_cloud)
      eye_.draw();
    else if (wants_depth)
      eye_.draw_depth();
    const Lens& lens = eye_.settings().lens;
    if (is_wanted(images_)) publish_stamped(images_, eye_.image(), now, frame_);
    if (wants_depth)
      publish_stamped(depths_, depth_message(eye_.camera(), lens.near, lens.far), now, frame_);
    if (wants_cloud)
      publish_stamped(clouds_,
                      depth_cloud_message(eye_.camera(), CloudAxes::kBody, lens.near, lens.far),
                      now, frame_);
  }
  void on_reset() override { rate_.reset(); }

 private:
  void listen(Host& host, const std::string& topic) {
    const std::string& given = eye_.settings().trigger_topic;
    triggers_ = subscribe_gz<std_msgs::msg::Bool>(
        host, given.empty() ? topic + "/trigger" : given,
        [this](const std_msgs::msg::Bool& message) { is_asked_ = is_asked_ || message.data; });
  }

  CameraEye eye_;
  Rate rate_;
  std::string frame_;
  sensor_msgs::msg::CameraInfo info_;
  bool is_asked_ = false;
  rclcpp::Subscription<std_msgs::msg::Bool>::SharedPtr triggers_;
  rclcpp::Publisher<sensor_msgs::msg::Image>::SharedPtr images_, depths_;
  rclcpp::Publisher<sensor_msgs::msg::CameraInfo>::SharedPtr infos_;
  rclcpp::Publisher<sensor_msgs::msg::PointCloud2>::SharedPtr clouds_;
};

}  // namespace

std::unique_ptr<System> make_gz_camera(const PluginContext& context) {
  return std::make_unique<GzCamera>(context, Kind::kColor);
}
std::unique_ptr<System> make_gz_depth_camera(const PluginContext& context) {
  return std::make_unique<GzCamera>(context, Kind::kDepth);
}
std::unique_ptr<System> make_gz_rgbd_camera(const PluginContext& context) {
  return std::make_unique<GzCamera>(context, Kind::kBoth);
}

}  // namespace ros2wasm_sim
