// Exported interfaces of chainable controllers.
#include "controller_interface/chainable_controller_interface.hpp"

#include <stdexcept>
#include <utility>

#include "hardware_interface/types/lifecycle_state_names.hpp"

namespace controller_interface {
namespace {

/// Adds one exported interface to the three collections.
template <typename InterfaceT>
void add_exported(const std::string& controller, const char* kind,
                  const std::shared_ptr<InterfaceT>& interface,
                  std::unordered_map<std::string, std::shared_ptr<InterfaceT>>& by_name,
                  std::vector<std::shared_ptr<InterfaceT>>& ordered,
                  std::vector<std::string>& names) {
  if (interface->get_prefix_name().find(controller) != 0) {
    throw std::runtime_error(
        "The prefix of the interface '" + interface->get_prefix_name() +
        "' should begin with the controller's name '" + controller + "'. This is mandatory for " +
        kind + " interfaces. Please correct and recompile the controller with name '" + controller +
        "' and try again.");
  }
  const std::string name = interface->get_name();
  if (!by_name.emplace(name, interface).second) {
    throw std::runtime_error("The controller '" + controller + "' exports the " + kind +
                             " interface '" + name +
                             "' twice. Please make the names of its interfaces unique.");
  }
  ordered.push_back(interface);
  names.push_back(name);
}

}  // namespace

return_type ChainableControllerInterface::update(const rclcpp::Time& time,
                                                 const rclcpp::Duration& period) {
  if (!is_in_chained_mode()) {
    const return_type result = update_reference_from_subscribers(time, period);
    if (result != return_type::OK) {
      return result;
    }
  }
  return update_and_write_commands(time, period);
}

std::vector<hardware_interface::StateInterface::ConstSharedPtr>
ChainableControllerInterface::export_state_interfaces() {
  exported_state_interfaces_.clear();
  ordered_exported_state_interfaces_.clear();
  std::vector<std::string> names;
  const auto add = [&](const std::shared_ptr<hardware_interface::StateInterface>& interface) {
    add_exported(get_name(), "state", interface, exported_state_interfaces_,
                 ordered_exported_state_interfaces_, names);
  };
  exported_state_interface_names_.clear();
  for (auto& interface : on_export_state_interfaces()) {
    add(std::make_shared<hardware_interface::StateInterface>(interface));
  }
  for (const auto& interface : on_export_state_interfaces_list()) {
    add(interface);
  }
  exported_state_interface_names_ = std::move(names);
  return {ordered_exported_state_interfaces_.begin(), ordered_exported_state_interfaces_.end()};
}

std::vector<hardware_interface::CommandInterface::SharedPtr>
ChainableControllerInterface::export_reference_interfaces() {
  exported_reference_interfaces_.clear();
  ordered_exported_reference_interfaces_.clear();
  exported_reference_interface_names_.clear();
  std::vector<std::string> names;
  const auto add = [&](const std::shared_ptr<hardware_interface::CommandInterface>& interface) {
    add_exported(get_name(), "reference", interface, exported_reference_interfaces_,
                 ordered_exported_reference_interfaces_, names);
  };
  auto by_value = on_export_reference_interfaces();
  if (reference_interfaces_.size() != by_value.size()) {
    throw std::runtime_error(
        "The internal storage for reference values 'reference_interfaces_' variable has size '" +
        std::to_string(reference_interfaces_.size()) + "', but it is expected to have the size '" +
        std::to_string(by_value.size()) +
        "' equal to the number of exported reference interfaces. Please correct and recompile the "
        "controller with name '" +
        get_name() + "' and try again.");
  }
  for (auto& interface : by_value) {
    add(std::make_shared<hardware_interface::CommandInterface>(std::move(interface)));
  }
  for (const auto& interface : on_export_reference_interfaces_list()) {
    add(interface);
  }
  exported_reference_interface_names_ = std::move(names);
  return ordered_exported_reference_interfaces_;
}

bool ChainableControllerInterface::set_chained_mode(bool chained_mode) {
  if (get_lifecycle_id() == lifecycle_msgs::msg::State::PRIMARY_STATE_ACTIVE) {
    RCLCPP_ERROR(get_node()->get_logger(),
                 "Can not change controller's chained mode because it is "
                 "no in '%s' state. "
                 "Current state is '%s'.",
                 hardware_interface::lifecycle_state_names::UNCONFIGURED,
                 get_lifecycle_state().label().c_str());
    return false;
  }
  const bool accepted = on_set_chained_mode(chained_mode);
  if (accepted) {
    in_chained_mode_ = chained_mode;
  }
  return accepted;
}

std::vector<hardware_interface::StateInterface>
ChainableControllerInterface::on_export_state_interfaces() {
  state_interfaces_values_.resize(exported_state_interface_names_.size(), 0.0);
  std::vector<hardware_interface::StateInterface> interfaces;
  for (std::size_t i = 0; i < exported_state_interface_names_.size(); ++i) {
    interfaces.emplace_back(get_name(), exported_state_interface_names_[i],
                            &state_interfaces_values_[i]);
  }
  return interfaces;
}

std::vector<hardware_interface::CommandInterface>
ChainableControllerInterface::on_export_reference_interfaces() {
  reference_interfaces_.resize(exported_reference_interface_names_.size(), 0.0);
  std::vector<hardware_interface::CommandInterface> interfaces;
  for (std::size_t i = 0; i < exported_reference_interface_names_.size(); ++i) {
    interfaces.emplace_back(get_name(), exported_reference_interface_names_[i],
                            &reference_interfaces_[i]);
  }
  return interfaces;
}

}  // namespace controller_interface
