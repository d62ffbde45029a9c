// A measured pose.
#pragma once

#include <array>
#include <string>

#include "geometry_msgs/msg/pose.hpp"
#include "semantic_components/semantic_component_interface.hpp"

namespace semantic_components {

class PoseSensor : public SemanticComponentInterface<geometry_msgs::msg::Pose> {
 public:
  explicit PoseSensor(const std::string& name)
      : SemanticComponentInterface(name, {{name + "/position.x"},
                                          {name + "/position.y"},
                                          {name + "/position.z"},
                                          {name + "/orientation.x"},
                                          {name + "/orientation.y"},
                                          {name + "/orientation.z"},
                                          {name + "/orientation.w"}}) {}

  std::array<double, 3> get_position() const {
    copy_values_into(data_);
    return {data_[0], data_[1], data_[2]};
  }
  std::array<double, 4> get_orientation() const {
    copy_values_into(data_);
    return {data_[3], data_[4], data_[5], data_[6]};
  }
  bool get_values_as_message(geometry_msgs::msg::Pose& message) const {
    copy_values_into(data_);
    message.position.x = data_[0];
    message.position.y = data_[1];
    message.position.z = data_[2];
    message.orientation.x = data_[3];
    message.orientation.y = data_[4];
    message.orientation.z = data_[5];
    message.orientation.w = data_[6];
    return true;
  }

 private:
  mutable std::array<double, 7> data_{{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0}};
};

}  // namespace semantic_components
