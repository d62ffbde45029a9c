// The base of controllers whose references other controllers can command.
#pragma once

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "controller_interface/controller_interface_base.hpp"
#include "hardware_interface/handle.hpp"

namespace controller_interface {

class ChainableControllerInterface : public ControllerInterfaceBase {
 public:
  ChainableControllerInterface() = default;
  ~ChainableControllerInterface() override = default;

  /// References come from subscribers, unless another controller has claimed them.
  return_type update(const rclcpp::Time& time, const rclcpp::Duration& period) final;
  bool is_chainable() const final { return true; }
  /// Throw std::runtime_error for a prefix that does not begin with the controller's name, and for
  /// a name that occurs twice.
  std::vector<hardware_interface::StateInterface::ConstSharedPtr> export_state_interfaces() final;
  std::vector<hardware_interface::CommandInterface::SharedPtr> export_reference_interfaces() final;
  /// Refused while the controller is active.
  bool set_chained_mode(bool chained_mode) final;
  bool is_in_chained_mode() const final { return in_chained_mode_; }

 protected:
  [[deprecated("Replaced by on_export_state_interfaces_list() method.")]] virtual std::vector<
      hardware_interface::StateInterface>
  on_export_state_interfaces();
  virtual std::vector<hardware_interface::StateInterface::SharedPtr>
  on_export_state_interfaces_list() {
    return {};
  }
  [[deprecated("Replaced by on_export_reference_interfaces_list() method.")]] virtual std::vector<
      hardware_interface::CommandInterface>
  on_export_reference_interfaces();
  virtual std::vector<hardware_interface::CommandInterface::SharedPtr>
  on_export_reference_interfaces_list() {
    return {};
  }
  virtual bool on_set_chained_mode(bool /*chained_mode*/) { return true; }

  virtual return_type update_reference_from_subscribers(const rclcpp::Time& time,
                                                        const rclcpp::Duration& period) = 0;
  virtual return_type update_and_write_commands(const rclcpp::Time& time,
                                                const rclcpp::Duration& period) = 0;

  std::vector<std::string> exported_state_interface_names_;
  std::vector<hardware_interface::StateInterface::SharedPtr> ordered_exported_state_interfaces_;
  std::unordered_map<std::string, hardware_interface::StateInterface::SharedPtr>
      exported_state_interfaces_;
  /// The values that the older form of export refers to.
  std::vector<double> state_interfaces_values_;

  std::vector<std::string> exported_reference_interface_names_;
  std::vector<double> reference_interfaces_;
  std::vector<hardware_interface::CommandInterface::SharedPtr>
      ordered_exported_reference_interfaces_;
  std::unordered_map<std::string, hardware_interface::CommandInterface::SharedPtr>
      exported_reference_interfaces_;

 private:
  bool in_chained_mode_ = false;
};

}  // namespace controller_interface
