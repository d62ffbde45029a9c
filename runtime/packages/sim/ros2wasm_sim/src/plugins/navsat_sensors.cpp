// Satellite receivers: libgazebo_ros_gps_sensor.so, and `navsat` of Gazebo Sim.
#include <geometry_msgs/msg/vector3_stamped.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "plugins/gz_sensor.hpp"
#include "plugins/messages.hpp"
#include "sensors/navsat.hpp"

namespace ros2wasm_sim {
namespace {

using sensor_msgs::msg::NavSatFix;

NavSat receiver_of(const PluginContext& context, Heading heading) {
  return {*context.sensor,
          context.physics(),
          context.model->name,
          context.link->name,
          context.simulation.world().spherical.value_or(SphericalCoordinates{}),
          heading,
          context.host.seed()};
}

NavSatFix fix_at(const Geographic& position) {
  NavSatFix message;
  message.status.status = sensor_msgs::msg::NavSatStatus::STATUS_FIX;
  message.latitude = position.latitude_deg;
  message.longitude = position.longitude_deg;
  message.altitude = position.altitude;
  return message;
}

const char* const kWhatTheWorldLacks =
    "the world lacks <spherical_coordinates><surface_model>EARTH_WGS84</surface_model>"
    "<latitude_deg>47.4</latitude_deg><longitude_deg>8.5</longitude_deg><elevation>400</elevation>"
    "<heading_deg>0</heading_deg></spherical_coordinates>";

class ClassicGpsSensor final : public System {
 public:
  explicit ClassicGpsSensor(const PluginContext& context)
      : node_(context.host, context.plugin),
        receiver_(receiver_of(context, Heading::kClassic)),
        rate_(context.sensor->update_rate),
        frame_(Parameters(context.plugin.xml).text("frame_name", context.link->name)) {
    if (context.sensor->type != "gps" && context.sensor->type != "navsat")
      throw PluginError("Parent is not a GPS sensor. Exiting.");
    if (!context.simulation.world().spherical)
      RCLCPP_WARN(node_->get_logger(), "positions are around latitude 0 and longitude 0, as %s",
                  kWhatTheWorldLacks);
    const rclcpp::QoS qos = rclcpp::SensorDataQoS().reliable();
    fixes_ = node_->create_publisher<NavSatFix>("~/out", qos);
    velocities_ = node_->create_publisher<geometry_msgs::msg::Vector3Stamped>("~/vel", qos);
  }

  void after_step(const Now& now) override {
    if (!rate_.due(now.time_ns)) return;
    if (fixes_->get_subscription_count() > 0) publish_fix(now);
    if (velocities_->get_subscription_count() == 0) return;
    geometry_msgs::msg::Vector3Stamped velocity;
    velocity.header.stamp = stamp_of(now.time_ns);
    velocity.header.frame_id = frame_;
    velocity.vector = vector_message(receiver_.velocity());
    velocities_->publish(velocity);
  }

  void on_reset() override { rate_.reset(); }

 private:
  void publish_fix(const Now& now) {
    NavSatFix message = fix_at(receiver_.position());
    message.header.stamp = stamp_of(now.time_ns);
    message.header.frame_id = frame_;
    message.status.service = sensor_msgs::msg::NavSatStatus::SERVICE_GPS;
    const auto variance = [](const Noise& noise) { return noise.stddev() * noise.stddev(); };
    message.position_covariance[0] = variance(receiver_.horizontal_noise());
    message.position_covariance[4] = variance(receiver_.horizontal_noise());
    message.position_covariance[8] = variance(receiver_.vertical_noise());
    message.position_covariance_type = NavSatFix::COVARIANCE_TYPE_DIAGONAL_KNOWN;
    fixes_->publish(message);
  }

  PluginNode node_;
  NavSat receiver_;
  Rate rate_;
  std::string frame_;
  rclcpp::Publisher<NavSatFix>::SharedPtr fixes_;
  rclcpp::Publisher<geometry_msgs::msg::Vector3Stamped>::SharedPtr velocities_;
};

class GzNavSat final : public GzSensor<NavSatFix> {
 public:
  explicit GzNavSat(const PluginContext& context)
      : GzSensor(context, "/navsat"), receiver_(receiver_of(context, Heading::kSim)) {}

 private:
  NavSatFix measure() override { return fix_at(receiver_.position()); }

  NavSat receiver_;
};

/// A sensor that has no place on the earth and never publishes.
class SilentSensor final : public System {};

}  // namespace

std::unique_ptr<System> make_classic_gps_sensor(const PluginContext& context) {
  return std::make_unique<ClassicGpsSensor>(context);
}

std::unique_ptr<System> make_gz_navsat(const PluginContext& context) {
  if (context.simulation.world().spherical) return std::make_unique<GzNavSat>(context);
  RCLCPP_WARN(context.host.node()->get_logger(), "sensor [%s] of type [%s] is silent: %s",
              context.sensor->name.c_str(), context.sensor->type.c_str(), kWhatTheWorldLacks);
  return std::make_unique<SilentSensor>();
}

}  // namespace ros2wasm_sim
