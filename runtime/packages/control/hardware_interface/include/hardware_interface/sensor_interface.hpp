// The base of plugins for hardware that is only read.
#pragma once

#include "hardware_interface/hardware_component_interface.hpp"

namespace hardware_interface {

class SensorInterface : public HardwareComponentInterface {
 public:
  std::vector<CommandInterface::SharedPtr> on_export_command_interfaces() override { return {}; }
  return_type write(const rclcpp::Time& /*time*/, const rclcpp::Duration& /*period*/) final {
    return return_type::OK;
  }
};

}  // namespace hardware_interface
