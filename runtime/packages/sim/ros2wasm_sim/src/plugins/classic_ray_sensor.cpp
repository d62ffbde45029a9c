// libgazebo_ros_ray_sensor.so: what a lidar measures, as one of four messages.
#include <algorithm>

#include "plugins/plugin.hpp"
#include "sensors/lidar_messages.hpp"

namespace ros2wasm_sim {
namespace {

/// Sensor data, but reliable, as upstream's publisher.
rclcpp::QoS sensor_qos() {
  return rclcpp::SensorDataQoS().reliable();
}

class ClassicRaySensor final : public System {
 public:
  explicit ClassicRaySensor(const PluginContext& context)
      : node_(context.host, context.plugin),
        lidar_(*context.sensor, context.physics(), context.model->name, context.link->name,
               context.host.seed()),
        rate_(context.sensor->update_rate) {
    const Parameters given(context.plugin.xml);
    frame_ = given.text("frame_name", context.link->name);
    is_ultrasound_ = given.text("radiation_type", "infrared") == "ultrasound";
    std::string type = given.text("output_type", "");
    if (type.empty()) {
      RCLCPP_WARN(node_->get_logger(),
                  "missing <output_type>, defaults to sensor_msgs/PointCloud2");
      type = "sensor_msgs/PointCloud2";
    }
    if (type == "sensor_msgs/LaserScan")
      scans_ = node_->create_publisher<sensor_msgs::msg::LaserScan>("~/out", sensor_qos());
    else if (type == "sensor_msgs/PointCloud2")
      clouds_ = node_->create_publisher<sensor_msgs::msg::PointCloud2>("~/out", sensor_qos());
    else if (type == "sensor_msgs/Range")
      ranges_ = node_->create_publisher<sensor_msgs::msg::Range>("~/out", sensor_qos());
    else
      throw PluginError("Invalid <output_type> [" + type + "]");
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns)) return;
    if (scans_ != nullptr)
      publish(scans_, now, [&] { return scan_message(lidar_.settings(), lidar_.measure()); });
    if (clouds_ != nullptr)
      publish(clouds_, now,
              [&] { return dense_cloud_message(lidar_.settings(), lidar_.measure()); });
    if (ranges_ != nullptr)
      publish(ranges_, now,
              [&] { return range_message(lidar_.settings(), lidar_.measure(), is_ultrasound_); });
  }

  void on_reset() override { rate_.reset(); }

 private:
  template <typename Publisher, typename Make>
  void publish(const Publisher& publisher, const Now& now, Make make) {
    if (publisher->get_subscription_count() == 0) return;
    auto message = make();
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    publisher->publish(message);
  }

  PluginNode node_;
  Lidar lidar_;
  Rate rate_;
  std::string frame_;
  bool is_ultrasound_ = false;
  rclcpp::Publisher<sensor_msgs::msg::LaserScan>::SharedPtr scans_;
  rclcpp::Publisher<sensor_msgs::msg::PointCloud2>::SharedPtr clouds_;
  rclcpp::Publisher<sensor_msgs::msg::Range>::SharedPtr ranges_;
};

}  // namespace

std::unique_ptr<System> make_classic_ray_sensor(const PluginContext& context) {
  return std::make_unique<ClassicRaySensor>(context);
}

}  // namespace ros2wasm_sim
