// Lidars of Gazebo Sim: `gpu_lidar`, with a scan and a cloud.
#include "plugins/gz_topics.hpp"
#include "plugins/sensor_names.hpp"
#include "sensors/lidar_messages.hpp"

namespace ros2wasm_sim {
namespace {

class GzLidar final : public System {
 public:
  explicit GzLidar(const PluginContext& context)
      : lidar_(*context.sensor, context.physics(), context.model->name, context.link->name,
               context.host.seed()),
        rate_(whole_milliseconds(context.sensor->update_rate)),
        frame_(sensor_frame(context)) {
    const std::string topic = sensor_topic(context, "/scan");
    scans_ = publish_gz<sensor_msgs::msg::LaserScan>(context.host, topic);
    clouds_ = publish_gz<sensor_msgs::msg::PointCloud2>(context.host, topic + "/points");
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns)) return;
    const bool scans = scans_->get_subscription_count() > 0,
               clouds = clouds_->get_subscription_count() > 0;
    if (!scans && !clouds) return;
    const std::vector<double>& ranges = lidar_.measure();
    if (scans) publish(*scans_, scan_message(lidar_.settings(), ranges), now);
    if (clouds) publish(*clouds_, organized_cloud_message(lidar_.settings(), ranges), now);
  }

  void on_reset() override { rate_.reset(); }

 private:
  template <typename Publisher, typename Message>
  void publish(Publisher& publisher, Message message, const Now& now) {
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    publisher.publish(message);
  }

  Lidar lidar_;
  Rate rate_;
  std::string frame_;
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
  rclcpp::Publisher<sensor_msgs::msg::PointCloud2>::SharedPtr clouds_;
};

}  // namespace

std::unique_ptr<System> make_gz_lidar(const PluginContext& context) {
  return std::make_unique<GzLidar>(context);
}

}  // namespace ros2wasm_sim
