// The force and torque of one sensor, or those of its axes that exist.
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "geometry_msgs/msg/wrench.hpp"
#include "semantic_components/semantic_component_interface.hpp"

namespace semantic_components {

class ForceTorqueSensor : public SemanticComponentInterface<geometry_msgs::msg::Wrench> {
 public:
  explicit ForceTorqueSensor(const std::string& name)
      : SemanticComponentInterface(name, {{name + "/force.x"},
                                          {name + "/force.y"},
                                          {name + "/force.z"},
                                          {name + "/torque.x"},
                                          {name + "/torque.y"},
                                          {name + "/torque.z"}}),
        existing_axes_({{true, true, true, true, true, true}}) {
    data_.fill(std::numeric_limits<double>::quiet_NaN());
  }
  /// An empty name is an axis that the sensor does not have: its value is NaN.
  ForceTorqueSensor(const std::string& interface_force_x, const std::string& interface_force_y,
                    const std::string& interface_force_z, const std::string& interface_torque_x,
                    const std::string& interface_torque_y, const std::string& interface_torque_z)
      : SemanticComponentInterface("", 6) {
    data_.fill(std::numeric_limits<double>::quiet_NaN());
    const std::array<std::string, 6> names = {interface_force_x,  interface_force_y,
                                              interface_force_z,  interface_torque_x,
                                              interface_torque_y, interface_torque_z};
    for (std::size_t i = 0; i < names.size(); ++i) {
      existing_axes_[i] = !names[i].empty();
      if (existing_axes_[i]) {
        interface_names_.push_back(names[i]);
      }
    }
  }

  std::array<double, 3> get_forces() const {
    update_data_from_interfaces();
    return {data_[0], data_[1], data_[2]};
  }
  std::array<double, 3> get_torques() const {
    update_data_from_interfaces();
    return {data_[3], data_[4], data_[5]};
  }
  bool get_values_as_message(geometry_msgs::msg::Wrench& message) const {
    update_data_from_interfaces();
    message.force.x = data_[0];
    message.force.y = data_[1];
    message.force.z = data_[2];
    message.torque.x = data_[3];
    message.torque.y = data_[4];
    message.torque.z = data_[5];
    return true;
  }

 protected:
  void update_data_from_interfaces() const {
    std::size_t next = 0;
    for (std::size_t i = 0; i < data_.size(); ++i) {
      if (!existing_axes_[i]) {
        continue;
      }
      if (const auto value = state_interfaces_[next].get().get_optional()) {
        data_[i] = *value;
      }
      ++next;
    }
  }

  mutable std::array<double, 6> data_;  ///< force x y z, torque x y z
  std::array<bool, 6> existing_axes_;
};

}  // namespace semantic_components
