// The argument of a plugin's on_init.
#pragma once

#include "hardware_interface/hardware_info.hpp"
#include "rclcpp/executor.hpp"

namespace hardware_interface {

struct HardwareComponentInterfaceParams {
  HardwareComponentInterfaceParams() = default;

  HardwareInfo hardware_info;
  /// Runs the node of the controller manager; a plugin may add its own nodes.
  rclcpp::Executor::WeakPtr executor;
};

}  // namespace hardware_interface
