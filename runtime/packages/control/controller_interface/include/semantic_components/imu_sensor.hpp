// The ten values of an IMU.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "semantic_components/semantic_component_interface.hpp"
#include "sensor_msgs/msg/imu.hpp"

namespace semantic_components {

class IMUSensor : public SemanticComponentInterface<sensor_msgs::msg::Imu> {
 public:
  explicit IMUSensor(const std::string& name)
      : SemanticComponentInterface(name, {{name + "/orientation.x"},
                                          {name + "/orientation.y"},
                                          {name + "/orientation.z"},
                                          {name + "/orientation.w"},
                                          {name + "/angular_velocity.x"},
                                          {name + "/angular_velocity.y"},
                                          {name + "/angular_velocity.z"},
                                          {name + "/linear_acceleration.x"},
                                          {name + "/linear_acceleration.y"},
                                          {name + "/linear_acceleration.z"}}) {}

  std::array<double, 4> get_orientation() const {
    copy_values_into(data_);
    return {data_[0], data_[1], data_[2], data_[3]};
  }
  std::array<double, 3> get_angular_velocity() const {
    copy_values_into(data_);
    return {data_[4], data_[5], data_[6]};
  }
  std::array<double, 3> get_linear_acceleration() const {
    copy_values_into(data_);
    return {data_[7], data_[8], data_[9]};
  }
  bool get_values_as_message(sensor_msgs::msg::Imu& message) const {
    copy_values_into(data_);
    message.orientation.x = data_[0];
    message.orientation.y = data_[1];
    message.orientation.z = data_[2];
    message.orientation.w = data_[3];
    message.angular_velocity.x = data_[4];
    message.angular_velocity.y = data_[5];
    message.angular_velocity.z = data_[6];
    message.linear_acceleration.x = data_[7];
    message.linear_acceleration.y = data_[8];
    message.linear_acceleration.z = data_[9];
    return true;
  }

 private:
  mutable std::array<double, 10> data_{{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
};

}  // namespace semantic_components
