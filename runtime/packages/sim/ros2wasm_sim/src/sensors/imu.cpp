// See imu.hpp.
#include "sensors/imu.hpp"

#include "plugins/messages.hpp"
#include "plugins/parameters.hpp"

namespace ros2wasm_sim {

Imu::Imu(const Sensor& sensor, Physics& physics, const std::string& model, const std::string& link,
         std::uint64_t seed)
    : pose_(sensor.pose),
      physics_(physics),
      link_(physics.link(model, link)),
      random_(seed, model + "::" + link + "::" + sensor.name),
      rate_noise_(read_axes(sensor, "angular_velocity")),
      acceleration_noise_(read_axes(sensor, "linear_acceleration")) {}

Imu::Axes Imu::read_axes(const Sensor& sensor, const char* kind) {
  const Parameters axes = Parameters(sensor.xml).inside("imu").inside(kind);
  const auto read = [&](const char* axis) {
    return Noise::read(sensor.xml, axes.inside(axis).find("noise"), random_);
  };
  return {read("x"), read("y"), read("z")};
}

Vector3 Imu::noisy(const Vector3& v, const Axes& noise) {
  return {noise.x.apply(v.x, random_), noise.y.apply(v.y, random_), noise.z.apply(v.z, random_)};
}

sensor_msgs::msg::Imu Imu::measure() {
  const Pose link = physics_.pose(link_), sensor = link * pose_;
  const Motion velocity = physics_.velocity(link_), felt = physics_.proper_acceleration(link_);
  const Vector3 arm = sensor.position - link.position;
  const Vector3 acceleration = felt.linear + cross(felt.angular, arm) +
                               cross(velocity.angular, cross(velocity.angular, arm));
  const Quaternion back = inverse(sensor.orientation);
  sensor_msgs::msg::Imu message;
  message.orientation = quaternion_message(reference_ * sensor.orientation);
  message.angular_velocity = vector_message(noisy(rotate(back, velocity.angular), rate_noise_));
  message.linear_acceleration =
      vector_message(noisy(rotate(back, acceleration), acceleration_noise_));
  const auto variance = [](const Noise& noise) { return noise.stddev() * noise.stddev(); };
  message.angular_velocity_covariance[0] = variance(rate_noise_.x);
  message.angular_velocity_covariance[4] = variance(rate_noise_.y);
  message.angular_velocity_covariance[8] = variance(rate_noise_.z);
  message.linear_acceleration_covariance[0] = variance(acceleration_noise_.x);
  message.linear_acceleration_covariance[4] = variance(acceleration_noise_.y);
  message.linear_acceleration_covariance[8] = variance(acceleration_noise_.z);
  return message;
}

}  // namespace ros2wasm_sim
