// A component as services report it.
#pragma once

#include <string>
#include <vector>

#include "rclcpp_lifecycle/state.hpp"

namespace hardware_interface {

struct HardwareComponentInfo {
  std::string name;
  std::string type;
  std::string group;
  std::string plugin_name;
  bool is_async = false;
  unsigned int rw_rate = 0;
  rclcpp_lifecycle::State state;
  std::vector<std::string> state_interfaces;
  std::vector<std::string> command_interfaces;
};

}  // namespace hardware_interface
