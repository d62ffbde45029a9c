// libgazebo_ros_camera.so: colours and, of a depth camera, distances and points.
#include <limits>

#include <std_msgs/msg/empty.hpp>

#include "plugins/camera_system.hpp"

namespace ros2wasm_sim {
namespace {

using sensor_msgs::msg::CameraInfo;
using sensor_msgs::msg::CompressedImage;
using sensor_msgs::msg::Image;
using sensor_msgs::msg::PointCloud2;

template <typename Message>
using PublisherOf = typename rclcpp::Publisher<Message>::SharedPtr;

/// One camera with its topics.
class Eye {
 public:
  Eye(const PluginContext& context, const PluginNode& node, const CameraSettings& settings,
      const std::string& name, bool has_depth)
      : eye_(context, settings) {
    const Parameters given(context.plugin.xml);
    frame_ = given.text("frame_name", context.link->name);
    min_depth_ = given.number("min_depth", 0.4);
    max_depth_ = given.number("max_depth", std::numeric_limits<double>::infinity());
    const auto publish = [&]<typename Message>(
                             std::shared_ptr<rclcpp::Publisher<Message>>& publisher,
                             const std::string& topic) {
      publisher = node->create_publisher<Message>(name + topic, rclcpp::SensorDataQoS().reliable());
    };
    publish(images_, "/image_raw");
    publish(compressed_, "/image_raw/compressed");
    publish(infos_, "/camera_info");
    if (has_depth) {
      publish(depths_, "/depth/image_raw");
      publish(depth_infos_, "/depth/camera_info");
      publish(clouds_, "/points");
    }
    // Gazebo Classic counts pixels from 1.
    const Lens& lens = settings.lens;
    info_ = info_message(
        settings, given.number("cx", 0) != 0 ? given.number("cx", 0) : (lens.width + 1) / 2.0,
        given.number("cy", 0) != 0 ? given.number("cy", 0) : (lens.height + 1) / 2.0,
        given.number("hack_baseline", 0));
  }

  void publish(const Now& now) {
    if (is_wanted(infos_)) publish_stamped(infos_, info_, now, frame_);
    if (is_wanted(depth_infos_)) publish_stamped(depth_infos_, info_, now, frame_);
    const bool wants_cloud = is_wanted(clouds_);
    const bool wants_color = is_wanted(images_) || is_wanted(compressed_) || wants_cloud;
    const bool wants_depth = is_wanted(depths_) || wants_cloud;
    if (wants_color)
      eye_.draw();
    else if (wants_depth)
      eye_.draw_depth();
    if (is_wanted(images_)) publish_stamped(images_, eye_.image(), now, frame_);
    if (is_wanted(compressed_)) publish_stamped(compressed_, eye_.jpeg(), now, frame_);
    if (is_wanted(depths_))
      publish_stamped(depths_, depth_message(eye_.camera(), min_depth_, max_depth_), now, frame_);
    if (wants_cloud)
      publish_stamped(
          clouds_, depth_cloud_message(eye_.camera(), CloudAxes::kOptical, min_depth_, max_depth_),
          now, frame_);
  }

 private:
  CameraEye eye_;
  std::string frame_;
  double min_depth_ = 0, max_depth_ = 0;  ///< metres
  CameraInfo info_;
  PublisherOf<Image> images_, depths_;
  PublisherOf<CompressedImage> compressed_;
  PublisherOf<CameraInfo> infos_, depth_infos_;
  PublisherOf<PointCloud2> clouds_;
};

class ClassicCamera final : public System {
 public:
  explicit ClassicCamera(const PluginContext& context)
      : node_(context.host, context.plugin), rate_(context.sensor->update_rate) {
    const Parameters given(context.plugin.xml);
    const std::string name = given.text("camera_name", context.sensor->name);
    const bool has_depth = context.sensor->type == "depth";
    const auto cameras = read_cameras(*context.sensor);
    const bool several = context.sensor->type == "multicamera";
    for (const CameraSettings& settings : cameras) {
      const std::string topic = several ? name + "/" + settings.name : name;
      eyes_.push_back(std::make_unique<Eye>(context, node_, settings, topic, has_depth));
      RCLCPP_INFO(node_->get_logger(), "Publishing camera info to [%s]",
                  resolved(topic + "/camera_info").c_str());
      if (!several) break;
    }
    if (given.flag("triggered", false)) {
      is_triggered_ = true;
      triggers_ = node_->create_subscription<std_msgs::msg::Empty>(
          name + "/image_trigger", rclcpp::QoS(1),
          [this](const std_msgs::msg::Empty&) { ++wanted_; });
    }
  }

  void after_step(const Now& now) override {
    if (is_triggered_ && wanted_ == 0) return;
    if (!rate_.due(now.time_ns)) return;
    if (is_triggered_) --wanted_;
    for (const auto& eye : eyes_) eye->publish(now);
  }
  void on_reset() override { rate_.reset(); }

 private:
  std::string resolved(const std::string& topic) const {
    return node_->get_node_topics_interface()->resolve_topic_name(topic);
  }

  PluginNode node_;
  Rate rate_;
  std::vector<std::unique_ptr<Eye>> eyes_;
  bool is_triggered_ = false;
  int wanted_ = 0;  ///< pictures that were asked for
  rclcpp::Subscription<std_msgs::msg::Empty>::SharedPtr triggers_;
};

}  // namespace

std::unique_ptr<System> make_classic_camera(const PluginContext& context) {
  if (context.sensor == nullptr)
    throw PluginError("libgazebo_ros_camera.so belongs into a <sensor>, not into a model.");
  return std::make_unique<ClassicCamera>(context);
}

}  // namespace ros2wasm_sim
