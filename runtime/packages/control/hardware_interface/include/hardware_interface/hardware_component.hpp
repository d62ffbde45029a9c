// A plugin with its life: the steps that the resource manager takes with it.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "hardware_interface/handle.hpp"
#include "hardware_interface/hardware_component_interface.hpp"
#include "hardware_interface/hardware_info.hpp"
#include "hardware_interface/types/hardware_interface_return_values.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_lifecycle/state.hpp"

namespace hardware_interface {

class HardwareComponent final {
 public:
  HardwareComponent() = default;
  explicit HardwareComponent(std::unique_ptr<HardwareComponentInterface> impl);
  HardwareComponent(HardwareComponent&& other) noexcept;
  HardwareComponent(const HardwareComponent& other) = delete;
  HardwareComponent& operator=(const HardwareComponent& other) = delete;
  HardwareComponent& operator=(HardwareComponent&& other) = delete;
  ~HardwareComponent() = default;

  /// Each returns the state after the step; a step that does not start at the present state
  /// changes nothing.
  const rclcpp_lifecycle::State& initialize(const HardwareComponentParams& params);
  const rclcpp_lifecycle::State& configure();
  const rclcpp_lifecycle::State& cleanup();
  const rclcpp_lifecycle::State& shutdown();
  const rclcpp_lifecycle::State& activate();
  const rclcpp_lifecycle::State& deactivate();
  const rclcpp_lifecycle::State& error();

  std::vector<StateInterface::ConstSharedPtr> export_state_interfaces();
  std::vector<CommandInterface::SharedPtr> export_command_interfaces();
  return_type prepare_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                          const std::vector<std::string>& stop_interfaces);
  return_type perform_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                          const std::vector<std::string>& stop_interfaces);

  const std::string& get_name() const;
  const std::string& get_group_name() const;
  const rclcpp_lifecycle::State& get_lifecycle_state() const;
  uint8_t get_lifecycle_id() const;
  const rclcpp::Time& get_last_read_time() const { return last_read_cycle_time_; }
  const rclcpp::Time& get_last_write_time() const { return last_write_cycle_time_; }

  /// Read when inactive or active, written when active.
  return_type read(const rclcpp::Time& time, const rclcpp::Duration& period);
  return_type write(const rclcpp::Time& time, const rclcpp::Duration& period);
  std::recursive_mutex& get_mutex() { return component_mutex_; }

 private:
  enum class Step { kConfigure, kCleanup, kShutdown, kActivate, kDeactivate };
  const rclcpp_lifecycle::State& take(Step step);

  std::unique_ptr<HardwareComponentInterface> impl_;
  mutable std::recursive_mutex component_mutex_;
  rclcpp::Time last_read_cycle_time_{0, 0, RCL_CLOCK_UNINITIALIZED};
  rclcpp::Time last_write_cycle_time_{0, 0, RCL_CLOCK_UNINITIALIZED};
};

}  // namespace hardware_interface
