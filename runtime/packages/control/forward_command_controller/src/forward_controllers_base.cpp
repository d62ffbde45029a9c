// See forward_controllers_base.hpp.
#include "forward_command_controller/forward_controllers_base.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <limits>

#include "controller_interface/helpers.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/qos.hpp"

namespace forward_command_controller {

using controller_interface::CallbackReturn;
using controller_interface::interface_configuration_type;
using controller_interface::InterfaceConfiguration;
using controller_interface::return_type;

CallbackReturn ForwardControllersBase::on_init() {
  try {
    declare_parameters();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Exception thrown during init stage with message: %s \n", error.what());
    return CallbackReturn::ERROR;
  }
  return CallbackReturn::SUCCESS;
}

InterfaceConfiguration ForwardControllersBase::command_interface_configuration() const {
  return {interface_configuration_type::INDIVIDUAL, command_interface_types_};
}

InterfaceConfiguration ForwardControllersBase::state_interface_configuration() const {
  return {interface_configuration_type::NONE, {}};
}

CallbackReturn ForwardControllersBase::on_configure(const rclcpp_lifecycle::State&) {
  const CallbackReturn read = read_parameters();
  if (read != CallbackReturn::SUCCESS) return read;

  joints_command_subscriber_ = get_node()->create_subscription<CmdType>(
      "~/commands", rclcpp::SystemDefaultsQoS(), [this](const CmdType::SharedPtr message) {
        const auto is_finite = [](double value) { return std::isfinite(value); };
        if (!std::all_of(message->data.begin(), message->data.end(), is_finite)) {
          RCLCPP_WARN_THROTTLE(get_node()->get_logger(), *get_node()->get_clock(), 1000,
                               "Non-finite value received. Dropping message");
          return;
        }
        rt_command_.set(*message);
      });
  RCLCPP_INFO(get_node()->get_logger(), "configure successful");
  return CallbackReturn::SUCCESS;
}

CallbackReturn ForwardControllersBase::on_activate(const rclcpp_lifecycle::State&) {
  std::vector<std::reference_wrapper<hardware_interface::LoanedCommandInterface>> ordered;
  if (!controller_interface::get_ordered_interfaces(command_interfaces_, command_interface_types_,
                                                    std::string(), ordered) ||
      command_interface_types_.size() != ordered.size()) {
    RCLCPP_ERROR(get_node()->get_logger(), "Expected %zu command interfaces, got %zu",
                 command_interface_types_.size(), ordered.size());
    return CallbackReturn::ERROR;
  }
  forget_commands();  // one that came before the activation does not count
  RCLCPP_INFO(get_node()->get_logger(), "activate successful");
  return CallbackReturn::SUCCESS;
}

CallbackReturn ForwardControllersBase::on_deactivate(const rclcpp_lifecycle::State&) {
  forget_commands();
  return CallbackReturn::SUCCESS;
}

void ForwardControllersBase::forget_commands() {
  std::fill(joint_commands_.data.begin(), joint_commands_.data.end(),
            std::numeric_limits<double>::quiet_NaN());
  rt_command_.try_set(joint_commands_);
}

return_type ForwardControllersBase::update(const rclcpp::Time&, const rclcpp::Duration&) {
  if (const auto newest = rt_command_.try_get()) joint_commands_ = *newest;
  const std::vector<double>& commands = joint_commands_.data;
  if (std::all_of(commands.begin(), commands.end(), [](double it) { return std::isnan(it); })) {
    return return_type::OK;
  }
  if (commands.size() != command_interfaces_.size()) {
    RCLCPP_ERROR_THROTTLE(get_node()->get_logger(), *get_node()->get_clock(), 1000,
                          "command size (%zu) does not match number of interfaces (%zu)",
                          commands.size(), command_interfaces_.size());
    return return_type::ERROR;
  }
  for (size_t i = 0; i < commands.size(); ++i) {
    if (!command_interfaces_[i].set_value(commands[i])) {
      RCLCPP_WARN(get_node()->get_logger(),
                  "Unable to set the command interface value %s: value = %f",
                  command_interfaces_[i].get_name().c_str(), commands[i]);
      return return_type::OK;
    }
  }
  return return_type::OK;
}

}  // namespace forward_command_controller
