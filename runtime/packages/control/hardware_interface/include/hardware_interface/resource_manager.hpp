// All hardware of one robot: loads the components, keeps their interfaces, lends them, and reads
// and writes them in turn.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "hardware_interface/actuator.hpp"
#include "hardware_interface/actuator_interface.hpp"
#include "hardware_interface/hardware_component_info.hpp"
#include "hardware_interface/hardware_info.hpp"
#include "hardware_interface/loaned_command_interface.hpp"
#include "hardware_interface/loaned_state_interface.hpp"
#include "hardware_interface/sensor.hpp"
#include "hardware_interface/sensor_interface.hpp"
#include "hardware_interface/system.hpp"
#include "hardware_interface/system_interface.hpp"
#include "hardware_interface/types/hardware_interface_return_values.hpp"
#include "hardware_interface/types/resource_manager_params.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/executor.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/node_interfaces/node_logging_interface.hpp"
#include "rclcpp/time.hpp"

namespace hardware_interface {

class ResourceStorage;

struct HardwareReadWriteStatus {
  return_type result = return_type::OK;
  std::vector<std::string> failed_hardware_names;
};

class ResourceManager {
 public:
  explicit ResourceManager(
      rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_interface,
      rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logger_interface);
  explicit ResourceManager(rclcpp::Clock::SharedPtr clock, rclcpp::Logger logger);
  explicit ResourceManager(
      const std::string& urdf,
      rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_interface,
      rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr logger_interface,
      bool activate_all = false, const unsigned int update_rate = 100);
  explicit ResourceManager(const std::string& urdf, rclcpp::Clock::SharedPtr clock,
                           rclcpp::Logger logger, bool activate_all = false,
                           const unsigned int update_rate = 100);
  explicit ResourceManager(const ResourceManagerParams& params, bool load);
  ResourceManager(const ResourceManager&) = delete;
  virtual ~ResourceManager();

  bool shutdown_components();

  /// False when a component of the description cannot be loaded or initialized; nothing is loaded
  /// then. Throws std::runtime_error for a description that cannot be read.
  virtual bool load_and_initialize_components(const std::string& urdf,
                                              const unsigned int update_rate = 100);
  virtual bool load_and_initialize_components(const ResourceManagerParams& params);
  /// Limits of the description apply to commands from then on.
  void import_joint_limiters(const std::string& urdf);
  bool are_components_initialized() const { return components_are_loaded_and_initialized_; }

  /// Throw std::runtime_error when the interface does not exist, is not available, or (a command)
  /// is claimed.
  LoanedStateInterface claim_state_interface(const std::string& key);
  LoanedCommandInterface claim_command_interface(const std::string& key);

  /// Names are sorted.
  std::vector<std::string> state_interface_keys() const;
  std::vector<std::string> available_state_interfaces() const;
  bool state_interface_is_available(const std::string& name) const;
  bool state_interface_exists(const std::string& key) const;
  std::string get_state_interface_data_type(const std::string& name) const;
  std::vector<std::string> command_interface_keys() const;
  std::vector<std::string> available_command_interfaces() const;
  bool command_interface_is_available(const std::string& interface) const;
  bool command_interface_is_claimed(const std::string& key) const;
  bool command_interface_exists(const std::string& key) const;
  std::string get_command_interface_data_type(const std::string& name) const;

  /// Interfaces of chainable controllers. They are available while their controller is active.
  void import_controller_exported_state_interfaces(
      const std::string& controller_name, std::vector<StateInterface::ConstSharedPtr>& interfaces);
  std::vector<std::string> get_controller_exported_state_interface_names(
      const std::string& controller_name);
  void make_controller_exported_state_interfaces_available(const std::string& controller_name);
  void make_controller_exported_state_interfaces_unavailable(const std::string& controller_name);
  void remove_controller_exported_state_interfaces(const std::string& controller_name);
  void import_controller_reference_interfaces(
      const std::string& controller_name,
      const std::vector<CommandInterface::SharedPtr>& interfaces);
  std::vector<std::string> get_controller_reference_interface_names(
      const std::string& controller_name);
  void make_controller_reference_interfaces_available(const std::string& controller_name);
  void make_controller_reference_interfaces_unavailable(const std::string& controller_name);
  void remove_controller_reference_interfaces(const std::string& controller_name);

  /// Which controllers go down with which hardware.
  void cache_controller_to_hardware(const std::string& controller_name,
                                    const std::vector<std::string>& interfaces);
  std::vector<std::string> get_cached_controllers_to_hardware(const std::string& hardware_name);

  size_t actuator_components_size() const;
  size_t sensor_components_size() const;
  size_t system_components_size() const;
  void import_component(std::unique_ptr<ActuatorInterface> actuator,
                        const HardwareComponentParams& params);
  void import_component(std::unique_ptr<SensorInterface> sensor,
                        const HardwareComponentParams& params);
  void import_component(std::unique_ptr<SystemInterface> system,
                        const HardwareComponentParams& params);
  void import_component(std::unique_ptr<ActuatorInterface> actuator,
                        const HardwareInfo& hardware_info);
  void import_component(std::unique_ptr<SensorInterface> sensor, const HardwareInfo& hardware_info);
  void import_component(std::unique_ptr<SystemInterface> system, const HardwareInfo& hardware_info);

  const std::unordered_map<std::string, HardwareComponentInfo>& get_components_status();
  const std::unordered_map<std::string, joint_limits::JointLimits>& get_hard_joint_limits() const;
  const std::unordered_map<std::string, joint_limits::SoftJointLimits>& get_soft_joint_limits()
      const;

  bool prepare_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                   const std::vector<std::string>& stop_interfaces);
  bool perform_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                   const std::vector<std::string>& stop_interfaces);
  /// Leads the component to a state, by as many steps as it takes.
  return_type set_component_state(const std::string& component_name,
                                  rclcpp_lifecycle::State& target_state);

  /// True when a command was changed by a limit.
  bool enforce_command_limits(const rclcpp::Duration& period);
  HardwareReadWriteStatus read(const rclcpp::Time& time, const rclcpp::Duration& period);
  HardwareReadWriteStatus write(const rclcpp::Time& time, const rclcpp::Duration& period);

  void set_on_component_state_switch_callback(std::function<void()> callback);
  const std::string& get_robot_description() const { return params_.robot_description; }

 protected:
  rclcpp::Logger get_logger() const { return params_.logger; }
  rclcpp::Clock::SharedPtr get_clock() const { return params_.clock; }

  /// Drops the hardware and the limits of a description that failed: the next one starts afresh.
  void remove_all_components();

  bool components_are_loaded_and_initialized_ = false;
  bool allow_controller_activation_with_inactive_hardware_ = false;
  bool return_failed_hardware_names_on_return_deactivate_write_cycle_ = true;

  /// One lock for all: the loop and the services take turns.
  mutable std::recursive_mutex resources_lock_;

 private:
  void release_command_interface(const std::string& key);
  HardwareComponentParams component_params(const HardwareInfo& info) const;
  bool import(std::unique_ptr<HardwareComponentInterface> component,
              const HardwareComponentParams& params);

  ResourceManagerParams params_;
  std::unique_ptr<ResourceStorage> storage_;
};

}  // namespace hardware_interface
