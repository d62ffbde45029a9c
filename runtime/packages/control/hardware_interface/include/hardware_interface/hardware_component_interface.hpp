// The base of plugins that drive hardware. User plugins derive from SystemInterface,
// ActuatorInterface or SensorInterface.
#pragma once

#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hardware_interface/component_parser.hpp"
#include "hardware_interface/handle.hpp"
#include "hardware_interface/hardware_info.hpp"
#include "hardware_interface/introspection.hpp"
#include "hardware_interface/types/hardware_component_interface_params.hpp"
#include "hardware_interface/types/hardware_component_params.hpp"
#include "hardware_interface/types/hardware_interface_return_values.hpp"
#include "hardware_interface/types/hardware_interface_type_values.hpp"
#include "hardware_interface/types/lifecycle_state_names.hpp"
#include "hardware_interface/types/trigger_type.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/duration.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/node.hpp"
#include "rclcpp/node_interfaces/node_clock_interface.hpp"
#include "rclcpp/time.hpp"
#include "rclcpp_lifecycle/node_interfaces/lifecycle_node_interface.hpp"
#include "rclcpp_lifecycle/state.hpp"

namespace hardware_interface {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

class HardwareComponentInterface
    : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface {
 public:
  HardwareComponentInterface();
  HardwareComponentInterface(const HardwareComponentInterface& other) = delete;
  HardwareComponentInterface(HardwareComponentInterface&& other) = delete;
  ~HardwareComponentInterface() override;

  [[deprecated("Use init(const HardwareComponentParams & params) instead.")]] CallbackReturn init(
      const HardwareInfo& hardware_info, rclcpp::Logger logger,
      rclcpp::node_interfaces::NodeClockInterface::SharedPtr clock_interface);
  [[deprecated("Use init(const HardwareComponentParams & params) instead.")]] CallbackReturn init(
      const HardwareInfo& hardware_info, rclcpp::Logger logger, rclcpp::Clock::SharedPtr clock);
  /// The framework's part of on_init.
  CallbackReturn init(const HardwareComponentParams& params);

  [[deprecated(
      "Use on_init(const HardwareComponentInterfaceParams & params) "
      "instead.")]] virtual CallbackReturn
  on_init(const HardwareInfo& hardware_info);
  /// Calls the older form, which fills info_ and the maps of interfaces.
  virtual CallbackReturn on_init(const HardwareComponentInterfaceParams& params);
  /// Options of the component's own node.
  virtual rclcpp::NodeOptions define_custom_node_options() const;

  /// The older form: when it returns anything, the newer one is not called.
  [[deprecated("Replaced by on_export_state_interfaces().")]] virtual std::vector<StateInterface>
  export_state_interfaces();
  virtual std::vector<InterfaceDescription> export_unlisted_state_interface_descriptions();
  /// One handle per state interface of the description, and those that it does not list.
  virtual std::vector<StateInterface::ConstSharedPtr> on_export_state_interfaces();
  [[deprecated(
      "Replaced by on_export_command_interfaces().")]] virtual std::vector<CommandInterface>
  export_command_interfaces();
  virtual std::vector<InterfaceDescription> export_unlisted_command_interface_descriptions();
  virtual std::vector<CommandInterface::SharedPtr> on_export_command_interfaces();

  /// Names of interfaces are joint/interface. An ERROR refuses the switch.
  virtual return_type prepare_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                                  const std::vector<std::string>& stop_interfaces);
  /// Called in the control loop.
  virtual return_type perform_command_mode_switch(const std::vector<std::string>& start_interfaces,
                                                  const std::vector<std::string>& stop_interfaces);

  HardwareComponentCycleStatus trigger_read(const rclcpp::Time& time,
                                            const rclcpp::Duration& period);
  virtual return_type read(const rclcpp::Time& time, const rclcpp::Duration& period) = 0;
  HardwareComponentCycleStatus trigger_write(const rclcpp::Time& time,
                                             const rclcpp::Duration& period);
  virtual return_type write(const rclcpp::Time& time, const rclcpp::Duration& period);

  const std::string& get_name() const;
  const std::string& get_group_name() const;
  const rclcpp_lifecycle::State& get_lifecycle_state() const;
  void set_lifecycle_state(const rclcpp_lifecycle::State& new_state);
  uint8_t get_lifecycle_id() const;

  virtual bool has_state(const std::string& interface_name) const;
  /// Throws std::runtime_error for an interface that the component does not have.
  virtual const StateInterface::SharedPtr& get_state_interface_handle(
      const std::string& interface_name) const;

  template <typename T>
  bool set_state(const StateInterface::SharedPtr& interface_handle, const T& value,
                 bool wait_until_set) {
    refuse_null(interface_handle.get(), "State", "set_state");
    return interface_handle->set_value(value, wait_until_set);
  }
  template <typename T>
  void set_state(const std::string& interface_name, const T& value) {
    std::ignore = set_state(get_state_interface_handle(interface_name), value, true);
  }
  template <typename T>
  bool get_state(const StateInterface::SharedPtr& interface_handle, T& state,
                 bool wait_until_get) const {
    refuse_null(interface_handle.get(), "State", "get_state");
    return interface_handle->get_value(state, wait_until_get);
  }
  template <typename T = double>
  T get_state(const std::string& interface_name) const {
    T state;
    get_state<T>(get_state_interface_handle(interface_name), state, true);
    return state;
  }

  virtual bool has_command(const std::string& interface_name) const;
  virtual const CommandInterface::SharedPtr& get_command_interface_handle(
      const std::string& interface_name) const;

  template <typename T>
  bool set_command(const CommandInterface::SharedPtr& interface_handle, const T& value,
                   bool wait_until_set) {
    refuse_null(interface_handle.get(), "Command", "set_command");
    return interface_handle->set_value(value, wait_until_set);
  }
  template <typename T>
  void set_command(const std::string& interface_name, const T& value) {
    std::ignore = set_command(get_command_interface_handle(interface_name), value, true);
  }
  template <typename T>
  bool get_command(const CommandInterface::SharedPtr& interface_handle, T& command,
                   bool wait_until_get) const {
    refuse_null(interface_handle.get(), "Command", "get_command");
    return interface_handle->get_value(command, wait_until_get);
  }
  template <typename T = double>
  T get_command(const std::string& interface_name) const {
    T command;
    get_command<T>(get_command_interface_handle(interface_name), command, true);
    return command;
  }

  virtual rclcpp::Logger get_logger() const;
  virtual rclcpp::Clock::SharedPtr get_clock() const;
  /// Made when it is first asked for, and null without an executor.
  virtual rclcpp::Node::SharedPtr get_node() const;
  const HardwareInfo& get_hardware_info() const;

  /// Components are read and written by the control loop, also those that ask for a thread of
  /// their own. These do nothing.
  void pause_async_operations() {}
  void stop_async_handler() {}
  void prepare_for_activation() {}
  void enable_introspection(bool /*enable*/) {}

 protected:
  HardwareInfo info_;
  /// By full name: joint/interface.
  std::unordered_map<std::string, InterfaceDescription> joint_state_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> joint_command_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> sensor_state_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> gpio_state_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> gpio_command_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> unlisted_state_interfaces_;
  std::unordered_map<std::string, InterfaceDescription> unlisted_command_interfaces_;

  rclcpp_lifecycle::State lifecycle_state_;

  /// Filled by the newer form of export, sorted by name.
  std::vector<StateInterface::SharedPtr> joint_states_;
  std::vector<CommandInterface::SharedPtr> joint_commands_;
  std::vector<StateInterface::SharedPtr> sensor_states_;
  std::vector<StateInterface::SharedPtr> gpio_states_;
  std::vector<CommandInterface::SharedPtr> gpio_commands_;
  std::vector<StateInterface::SharedPtr> unlisted_states_;
  std::vector<CommandInterface::SharedPtr> unlisted_commands_;

 private:
  /// Throws std::runtime_error for a null handle.
  void refuse_null(const Handle* handle, const char* kind, const char* method) const;
  StateInterface::SharedPtr add_state(const InterfaceDescription& description);
  CommandInterface::SharedPtr add_command(const InterfaceDescription& description);

  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace hardware_interface
