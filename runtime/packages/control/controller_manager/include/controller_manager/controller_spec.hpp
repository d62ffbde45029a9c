// A controller as the manager holds it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller_interface/controller_interface_base.hpp"
#include "hardware_interface/controller_info.hpp"
#include "rclcpp/time.hpp"

namespace controller_manager {

struct ControllerSpec {
  hardware_interface::ControllerInfo info;
  controller_interface::ControllerInterfaceBaseSharedPtr c;
  /// Uninitialized until the first update after an activation.
  std::shared_ptr<rclcpp::Time> last_update_cycle_time =
      std::make_shared<rclcpp::Time>(0, 0, RCL_CLOCK_UNINITIALIZED);
  /// All controllers of its chain, itself included.
  std::vector<std::string> controllers_chain_group = {};
};

struct ControllerChainSpec {
  std::vector<std::string> following_controllers;
  std::vector<std::string> preceding_controllers;
};

}  // namespace controller_manager
