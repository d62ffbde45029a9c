// A measured magnetic field.
#pragma once

#include <array>
#include <string>

#include "semantic_components/semantic_component_interface.hpp"
#include "sensor_msgs/msg/magnetic_field.hpp"

namespace semantic_components {

class MagneticFieldSensor : public SemanticComponentInterface<sensor_msgs::msg::MagneticField> {
 public:
  explicit MagneticFieldSensor(const std::string& name)
      : SemanticComponentInterface(name, {{name + "/magnetic_field.x"},
                                          {name + "/magnetic_field.y"},
                                          {name + "/magnetic_field.z"}}) {}

  /// Tesla.
  bool get_values_as_message(sensor_msgs::msg::MagneticField& message) {
    copy_values_into(data_);
    message.magnetic_field.x = data_[0];
    message.magnetic_field.y = data_[1];
    message.magnetic_field.z = data_[2];
    return true;
  }

 private:
  std::array<double, 3> data_{{0.0, 0.0, 0.0}};
};

}  // namespace semantic_components
