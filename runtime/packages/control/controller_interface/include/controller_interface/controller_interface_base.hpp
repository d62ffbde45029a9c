// The base of all controllers: a managed node, the interfaces it has claimed, and its update.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "controller_interface/controller_interface_params.hpp"
#include "hardware_interface/handle.hpp"
#include "hardware_interface/introspection.hpp"
#include "hardware_interface/loaned_command_interface.hpp"
#include "hardware_interface/loaned_state_interface.hpp"
#include "lifecycle_msgs/msg/state.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"

namespace controller_interface {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;

enum class return_type : std::uint8_t {
  OK = 0,
  ERROR = 1,
};

enum class interface_configuration_type : std::uint8_t {
  ALL = 0,
  INDIVIDUAL = 1,
  NONE = 2,
  INDIVIDUAL_BEST_EFFORT = 3,  ///< those of the names that exist
  REGEX = 10,                  ///< those that match one of the names
};

struct InterfaceConfiguration {
  interface_configuration_type type = interface_configuration_type::NONE;
  std::vector<std::string> names = {};
};

struct ControllerUpdateStats {
  void reset() { total_triggers = failed_triggers = 0; }
  unsigned int total_triggers = 0;
  unsigned int failed_triggers = 0;
};

struct ControllerUpdateStatus {
  bool successful = true;
  return_type result = return_type::OK;
  std::optional<std::chrono::nanoseconds> execution_time = std::nullopt;
  std::optional<rclcpp::Duration> period = std::nullopt;
};

class ControllerInterfaceBase : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface {
 public:
  ControllerInterfaceBase();
  ~ControllerInterfaceBase() override;

  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;

  /// Called by the manager before the controller is activated, and after it was deactivated.
  virtual void assign_interfaces(
      std::vector<hardware_interface::LoanedCommandInterface>&& command_interfaces,
      std::vector<hardware_interface::LoanedStateInterface>&& state_interfaces);
  virtual void release_interfaces();

  return_type init(const std::string& controller_name, const std::string& urdf,
                   unsigned int cm_update_rate, const std::string& node_namespace,
                   const rclcpp::NodeOptions& node_options);
  return_type init(const ControllerInterfaceParams& params);
  const rclcpp_lifecycle::State& configure();

  virtual CallbackReturn on_init() = 0;
  virtual return_type update(const rclcpp::Time& time, const rclcpp::Duration& period) = 0;
  ControllerUpdateStatus trigger_update(const rclcpp::Time& time, const rclcpp::Duration& period);

  /// Throw std::runtime_error before init.
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node();
  std::shared_ptr<const rclcpp_lifecycle::LifecycleNode> get_node() const;
  const rclcpp_lifecycle::State& get_lifecycle_state() const;
  uint8_t get_lifecycle_id() const;

  unsigned int get_update_rate() const;
  /// Updates are called by the control loop, also for a controller that asks for a thread of its
  /// own.
  bool is_async() const;
  const std::string& get_robot_description() const;
  const std::unordered_map<std::string, joint_limits::JointLimits>& get_hard_joint_limits() const;
  const std::unordered_map<std::string, joint_limits::SoftJointLimits>& get_soft_joint_limits()
      const;

  virtual rclcpp::NodeOptions define_custom_node_options() const {
    rclcpp::NodeOptions node_options;
    node_options.enable_logger_service(true);
    return node_options;
  }

  /// The value of a parameter, which is declared when it is not yet.
  template <typename ParameterT>
  auto auto_declare(const std::string& name, const ParameterT& default_value) {
    if (!get_node()->has_parameter(name)) {
      return get_node()->template declare_parameter<ParameterT>(name, default_value);
    }
    return get_node()->get_parameter(name).template get_value<ParameterT>();
  }

  virtual bool is_chainable() const = 0;
  virtual std::vector<hardware_interface::CommandInterface::SharedPtr>
  export_reference_interfaces() = 0;
  virtual std::vector<hardware_interface::StateInterface::ConstSharedPtr>
  export_state_interfaces() = 0;
  virtual bool set_chained_mode(bool chained_mode) = 0;
  virtual bool is_in_chained_mode() const = 0;

  /// Nothing runs beside the control loop, so there is nothing to wait for.
  void wait_for_trigger_update_to_finish() {}
  void prepare_for_deactivation() {}
  void enable_introspection(bool /*enable*/) {}
  std::string get_name() const;

 protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;

 private:
  struct Parts;
  void register_transitions();
  void choose_update_rate();

  std::unique_ptr<Parts> parts_;
};

using ControllerInterfaceBaseSharedPtr = std::shared_ptr<ControllerInterfaceBase>;

}  // namespace controller_interface
