// Sensors of Gazebo Sim for what is everywhere in a world: `altimeter`, `air_pressure` and
// `magnetometer`.
#include <ros_gz_interfaces/msg/altimeter.hpp>
#include <sensor_msgs/msg/fluid_pressure.hpp>
#include <sensor_msgs/msg/magnetic_field.hpp>

#include "plugins/gz_sensor.hpp"
#include "plugins/messages.hpp"
#include "sensors/altimeter.hpp"
#include "sensors/magnetometer.hpp"

namespace ros2wasm_sim {
namespace {

class GzAltimeter final : public GzSensor<ros_gz_interfaces::msg::Altimeter> {
 public:
  explicit GzAltimeter(const PluginContext& context)
      : GzSensor(context, "/altimeter"),
        altimeter_(*context.sensor, context.physics(), context.model->name, context.link->name,
                   context.host.seed()) {}

 private:
  ros_gz_interfaces::msg::Altimeter measure() override {
    ros_gz_interfaces::msg::Altimeter message;
    message.vertical_position = altimeter_.position();
    message.vertical_velocity = altimeter_.velocity();
    message.vertical_reference = altimeter_.reference();
    return message;
  }

  Altimeter altimeter_;
};

class GzAirPressure final : public GzSensor<sensor_msgs::msg::FluidPressure> {
 public:
  explicit GzAirPressure(const PluginContext& context)
      : GzSensor(context, "/air_pressure"),
        pressure_(*context.sensor, context.physics(), context.model->name, context.link->name,
                  context.host.seed()) {}

 private:
  sensor_msgs::msg::FluidPressure measure() override {
    sensor_msgs::msg::FluidPressure message;
    message.fluid_pressure = pressure_.measure();
    message.variance = pressure_.variance();
    return message;
  }

  AirPressure pressure_;
};

class GzMagnetometer final : public GzSensor<sensor_msgs::msg::MagneticField> {
 public:
  explicit GzMagnetometer(const PluginContext& context)
      : GzSensor(context, "/magnetometer"),
        magnetometer_(*context.sensor, context.physics(), context.model->name, context.link->name,
                      context.simulation.world().magnetic_field, context.host.seed()) {}

 private:
  sensor_msgs::msg::MagneticField measure() override {
    sensor_msgs::msg::MagneticField message;
    message.magnetic_field = vector_message(magnetometer_.measure());
    const auto variance = [](const Noise& noise) { return noise.stddev() * noise.stddev(); };
    message.magnetic_field_covariance[0] = variance(magnetometer_.noise().x);
    message.magnetic_field_covariance[4] = variance(magnetometer_.noise().y);
    message.magnetic_field_covariance[8] = variance(magnetometer_.noise().z);
    return message;
  }

  Magnetometer magnetometer_;
};

}  // namespace

std::unique_ptr<System> make_gz_altimeter(const PluginContext& context) {
  return std::make_unique<GzAltimeter>(context);
}
std::unique_ptr<System> make_gz_air_pressure(const PluginContext& context) {
  return std::make_unique<GzAirPressure>(context);
}
std::unique_ptr<System> make_gz_magnetometer(const PluginContext& context) {
  return std::make_unique<GzMagnetometer>(context);
}

}  // namespace ros2wasm_sim
