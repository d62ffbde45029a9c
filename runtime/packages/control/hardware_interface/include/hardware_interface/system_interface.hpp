// The base of plugins for hardware with joints, sensors and gpios.
#pragma once

#include "hardware_interface/hardware_component_interface.hpp"

namespace hardware_interface {

class SystemInterface : public HardwareComponentInterface {
 public:
  return_type write(const rclcpp::Time& time, const rclcpp::Duration& period) override = 0;
};

}  // namespace hardware_interface
