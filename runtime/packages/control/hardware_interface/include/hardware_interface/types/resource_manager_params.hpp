// The parameters of a resource manager.
#pragma once

#include <string>

#include "rclcpp/clock.hpp"
#include "rclcpp/executor.hpp"
#include "rclcpp/logger.hpp"

namespace hardware_interface {

struct ResourceManagerParams {
  ResourceManagerParams() = default;

  std::string robot_description = "";
  rclcpp::Clock::SharedPtr clock = nullptr;
  rclcpp::Logger logger = rclcpp::get_logger("resource_manager");
  std::string node_namespace = "";
  rclcpp::Executor::SharedPtr executor = nullptr;
  bool activate_all = false;
  bool allow_controller_activation_with_inactive_hardware = false;
  bool return_failed_hardware_names_on_return_deactivate_write_cycle_ = true;
  unsigned int update_rate = 100;  ///< Hz, of the controller manager
  bool handle_exceptions = true;   ///< those of plugins become errors of their component
};

}  // namespace hardware_interface
