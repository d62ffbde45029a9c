// The parameters that the framework gives a component.
#pragma once

#include <string>

#include "hardware_interface/hardware_info.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/executor.hpp"
#include "rclcpp/logger.hpp"

namespace hardware_interface {

struct HardwareComponentParams {
  HardwareComponentParams() = default;

  HardwareInfo hardware_info;
  rclcpp::Logger logger = rclcpp::get_logger("resource_manager");
  rclcpp::Clock::SharedPtr clock = nullptr;
  std::string node_namespace = "";
  rclcpp::Executor::WeakPtr executor;
};

}  // namespace hardware_interface
