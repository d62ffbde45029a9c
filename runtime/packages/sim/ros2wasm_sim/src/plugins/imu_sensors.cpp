// IMUs: libgazebo_ros_imu_sensor.so of Gazebo Classic, and the sensor of Gazebo Sim.
#include "plugins/gz_topics.hpp"
#include "plugins/sensor_names.hpp"
#include "sensors/imu.hpp"

namespace ros2wasm_sim {
namespace {

Imu imu_of(const PluginContext& context) {
  return {*context.sensor, context.physics(), context.model->name, context.link->name,
          context.host.seed()};
}

/// Both publish the same at a rate; they differ in node, topic, frame and reference.
class ImuSystem : public System {
 public:
  ImuSystem(const PluginContext& context, double hz, std::string frame)
      : imu_(imu_of(context)), rate_(hz), frame_(std::move(frame)) {}

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns) || publisher_->get_subscription_count() == 0) return;
    auto message = imu_.measure();
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    publisher_->publish(message);
  }
  void on_reset() override { rate_.reset(); }

 protected:
  Imu imu_;
  rclcpp::Publisher<sensor_msgs::msg::Imu>::SharedPtr publisher_;

 private:
  Rate rate_;
  std::string frame_;
};

class ClassicImuSensor final : public ImuSystem {
 public:
  explicit ClassicImuSensor(const PluginContext& context)
      : ImuSystem(context, context.sensor->update_rate,
                  Parameters(context.plugin.xml).text("frame_name", context.link->name)),
        node_(context.host, context.plugin) {
    // REP 145: the orientation is in the world, unless the plugin asks for the old way.
    if (!Parameters(context.plugin.xml).has("initial_orientation_as_reference")) {
      RCLCPP_WARN(node_->get_logger(),
                  "<initial_orientation_as_reference> is unset, using default value of false to "
                  "comply with REP "
                  "145 (world as orientation reference)");
    }
    if (Parameters(context.plugin.xml).flag("initial_orientation_as_reference", false))
      imu_.take_reference();
    publisher_ =
        node_->create_publisher<sensor_msgs::msg::Imu>("~/out", rclcpp::SensorDataQoS().reliable());
  }

 private:
  PluginNode node_;
};

class GzImu final : public ImuSystem {
 public:
  explicit GzImu(const PluginContext& context)
      : ImuSystem(context, whole_milliseconds(context.sensor->update_rate), sensor_frame(context)) {
    const Parameters frame =
        Parameters(context.sensor->xml).inside("imu/orientation_reference_frame");
    if (!frame.has("localization")) imu_.take_reference();
    publisher_ = publish_gz<sensor_msgs::msg::Imu>(context.host, sensor_topic(context, "/imu"));
  }
};

}  // namespace

std::unique_ptr<System> make_classic_imu_sensor(const PluginContext& context) {
  return std::make_unique<ClassicImuSensor>(context);
}
std::unique_ptr<System> make_gz_imu(const PluginContext& context) {
  return std::make_unique<GzImu>(context);
}

}  // namespace ros2wasm_sim
