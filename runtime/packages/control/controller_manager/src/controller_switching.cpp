// The switch of controllers: from the request to the loop.
#include <chrono>
#include <typeinfo>
#include <utility>

#include "controller_manager/controller_manager.hpp"
#include "hardware_interface/helpers.hpp"
#include "interface_names.hpp"
#include "switch_plan.hpp"

namespace controller_manager {

using lifecycle_msgs::msg::State;
using Switch = controller_manager_msgs::srv::SwitchController::Request;
using Lock = std::unique_lock<std::recursive_mutex>;

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += name + " ";
  }
  return text;
}

std::string spaced(const std::vector<std::string>& names) {
  const std::string text = joined(names);
  return text.substr(0, text.empty() ? 0 : text.size() - 1);
}

InterfacesNow interfaces_now(const hardware_interface::ResourceManager& resources) {
  InterfacesNow now;
  for (const std::string& name : resources.available_command_interfaces()) {
    now.available_commands.insert(name);
    if (resources.command_interface_is_claimed(name)) {
      now.claimed_commands.insert(name);
    }
  }
  for (const std::string& name : resources.available_state_interfaces()) {
    now.available_states.insert(name);
  }
  return now;
}

}  // namespace

int ControllerManager::known_strictness(int strictness) {
  const bool default_is_strict =
      get_parameter("defaults.switch_controller.strictness").as_string() == "strict";
  if (strictness == 0) {
    RCLCPP_WARN_ONCE(get_logger(),
                     "Controller Manager: to switch controllers you need to specify a strictness "
                     "level of controller_manager_msgs::SwitchController::STRICT (%d) or "
                     "::BEST_EFFORT (%d). When unspecified, the default is %s",
                     Switch::STRICT, Switch::BEST_EFFORT,
                     default_is_strict ? "STRICT" : "BEST_EFFORT");
    return default_is_strict ? Switch::STRICT : Switch::BEST_EFFORT;
  }
  if (strictness == Switch::AUTO) {
    RCLCPP_WARN(get_logger(),
                "Controller Manager: AUTO is not currently implemented. Defaulting to BEST_EFFORT");
  }
  return strictness == Switch::STRICT ? Switch::STRICT : Switch::BEST_EFFORT;
}

ControllerManager::ReturnType ControllerManager::switch_controller(
    const std::vector<std::string>& activate_controllers,
    const std::vector<std::string>& deactivate_controllers, int strictness, bool activate_asap,
    const rclcpp::Duration& timeout) {
  std::string message;
  return switch_controller_cb(activate_controllers, deactivate_controllers, strictness,
                              activate_asap, timeout, message);
}

ControllerManager::ReturnType ControllerManager::switch_controller_cb(
    const std::vector<std::string>& activate_controllers,
    const std::vector<std::string>& deactivate_controllers, int strictness, bool /*activate_asap*/,
    const rclcpp::Duration& timeout, std::string& message) {
  if (!is_resource_manager_initialized()) {
    message =
        "Resource Manager is not initialized yet! Please provide robot description on "
        "'robot_description' topic before trying to switch controllers.";
    RCLCPP_ERROR(get_logger(), "%s", message.c_str());
    return ReturnType::ERROR;
  }
  strictness = known_strictness(strictness);
  if (!activate_controllers.empty()) {
    RCLCPP_INFO(get_logger(), "Activating controllers: [ %s]",
                joined(activate_controllers).c_str());
  }
  if (!deactivate_controllers.empty()) {
    RCLCPP_INFO(get_logger(), "Deactivating controllers: [ %s]",
                joined(deactivate_controllers).c_str());
  }
  Lock lock(controllers_lock_);
  const SwitchRequest request{activate_controllers, deactivate_controllers,
                              strictness == Switch::STRICT};
  SwitchPlan plan = plan_switch(request, controller_views(), interfaces_now(*resource_manager_));
  for (const std::string& warning : plan.warnings) {
    RCLCPP_WARN(get_logger(), "%s", warning.c_str());
  }
  message = plan.message;
  if (!plan.ok) {
    if (request.is_strict) {
      RCLCPP_ERROR(get_logger(), "Aborting, no controller is switched! (::STRICT switch)");
    }
    return ReturnType::ERROR;
  }
  if (plan.is_empty()) {
    RCLCPP_INFO(get_logger(), "%s", message.c_str());
    return ReturnType::OK;
  }
  for (const std::string& name : plan.activate) {
    auto used = names_of(find_controller(name)->c->command_interface_configuration(),
                         resource_manager_->available_command_interfaces());
    const auto states = names_of(find_controller(name)->c->state_interface_configuration(),
                                 resource_manager_->available_state_interfaces());
    used.insert(used.end(), states.begin(), states.end());
    resource_manager_->cache_controller_to_hardware(name, used);
  }
  // References of controllers that this switch activates can be named to the hardware from now on.
  std::vector<std::string> opened;
  for (const std::string& name : plan.to_chained_mode) {
    if (find_controller(name)->c->get_lifecycle_id() != State::PRIMARY_STATE_ACTIVE) {
      resource_manager_->make_controller_reference_interfaces_available(name);
      opened.push_back(name);
    }
  }
  if (!resource_manager_->prepare_command_mode_switch(plan.start_interfaces,
                                                      plan.stop_interfaces)) {
    for (const std::string& name : opened) {
      resource_manager_->make_controller_reference_interfaces_unavailable(name);
    }
    message = "Could not switch controllers since prepare command mode switch was rejected.";
    RCLCPP_ERROR(get_logger(), "%s", message.c_str());
    return ReturnType::ERROR;
  }
  asked_switch_ = std::make_unique<SwitchPlan>(plan);
  asked_strictness_ = strictness;
  message.clear();
  if (loop_thread_ == std::thread::id() || loop_thread_ == std::this_thread::get_id()) {
    manage_switch();
  } else {
    const auto wait = timeout.nanoseconds() == 0 ? std::chrono::nanoseconds(std::chrono::seconds(1))
                                                 : std::chrono::nanoseconds(timeout.nanoseconds());
    if (!switch_done_.wait_for(lock, wait, [this] { return asked_switch_ == nullptr; })) {
      asked_switch_.reset();
      message =
          "Switch controller timed out after " + std::to_string(wait.count() / 1e9) + " seconds!";
      RCLCPP_ERROR(get_logger(), "%s", message.c_str());
      return ReturnType::ERROR;
    }
  }
  const ReturnType result = switch_result(plan, strictness, message);
  publish_activity();
  return result;
}

ControllerManager::ReturnType ControllerManager::switch_result(const SwitchPlan& plan,
                                                               int strictness,
                                                               std::string& message) {
  std::vector<std::string> not_activated;
  std::vector<std::string> not_deactivated;
  for (ControllerSpec& spec : controllers_) {
    const std::string& name = spec.info.name;
    const bool is_active = spec.c->get_lifecycle_id() == State::PRIMARY_STATE_ACTIVE;
    if (!is_active && ros2_control::has_item(plan.activate, name)) {
      not_activated.push_back(name);
      RCLCPP_ERROR(get_logger(), "Could not activate controller : '%s'", name.c_str());
    } else if (is_active && ros2_control::has_item(plan.deactivate, name) &&
               !ros2_control::has_item(plan.activate, name)) {
      not_deactivated.push_back(name);
      RCLCPP_ERROR(get_logger(), "Could not deactivate controller : '%s'", name.c_str());
    }
  }
  if (not_activated.empty() && not_deactivated.empty()) {
    message = "Successfully switched controllers!";
    if (strictness != Switch::STRICT) {
      message += plan.deactivate.empty()
                     ? ""
                     : "\n Deactivated controllers: [ " + spaced(plan.deactivate) + " ]";
      message += plan.activate.empty()
                     ? ""
                     : "\n Activated controllers: [ " + spaced(plan.activate) + " ]";
    }
    RCLCPP_INFO(get_logger(), "%s", message.c_str());
    return ReturnType::OK;
  }
  message = "Failed switching controllers.... ";
  if (!not_activated.empty()) {
    message += "\nUnable to activate controllers: [ " + joined(not_activated) + " ]";
  }
  if (!not_deactivated.empty()) {
    message += "\nUnable to deactivate controllers: [ " + joined(not_deactivated) + " ]";
  }
  RCLCPP_ERROR(get_logger(), "%s", message.c_str());
  return ReturnType::ERROR;
}

/// In the thread of the loop, between the updates.
void ControllerManager::manage_switch() {
  const Lock lock(controllers_lock_);
  if (!asked_switch_) {
    return;
  }
  const std::unique_ptr<SwitchPlan> plan = std::move(asked_switch_);
  if (!resource_manager_->perform_command_mode_switch(plan->start_interfaces,
                                                      plan->stop_interfaces)) {
    RCLCPP_ERROR(get_logger(), "Error while performing mode switch.");
  } else {
    deactivate_controllers(plan->deactivate);
    switch_chained_mode(plan->to_chained_mode, true);
    switch_chained_mode(plan->from_chained_mode, false);
    activate_controllers(plan->activate, asked_strictness_);
  }
  switch_done_.notify_all();
}

void ControllerManager::deactivate_controllers(
    const std::vector<std::string>& controllers_to_deactivate) {
  for (const std::string& name : controllers_to_deactivate) {
    ControllerSpec* const spec = find_controller(name);
    if (spec == nullptr || spec->c->get_lifecycle_id() != State::PRIMARY_STATE_ACTIVE) {
      continue;
    }
    try {
      const auto& after = spec->c->get_node()->deactivate();
      spec->c->release_interfaces();
      if (after.id() != State::PRIMARY_STATE_INACTIVE) {
        RCLCPP_ERROR(get_logger(),
                     "After deactivating, controller '%s' is in state '%s', expected Inactive",
                     name.c_str(), after.label().c_str());
      }
    } catch (const std::exception& error) {
      RCLCPP_ERROR(get_logger(),
                   "Caught exception of type : %s while deactivating the  controller '%s': %s",
                   typeid(error).name(), name.c_str(), error.what());
      if (!handle_exceptions_) {
        throw;
      }
    }
    spec->info.claimed_interfaces.clear();
    if (spec->c->is_chainable()) {
      resource_manager_->make_controller_exported_state_interfaces_unavailable(name);
      resource_manager_->make_controller_reference_interfaces_unavailable(name);
    }
  }
}

void ControllerManager::switch_chained_mode(
    const std::vector<std::string>& chained_mode_switch_list, bool to_chained_mode) {
  for (const std::string& name : chained_mode_switch_list) {
    ControllerSpec* const spec = find_controller(name);
    if (spec != nullptr && !spec->c->set_chained_mode(to_chained_mode)) {
      RCLCPP_ERROR(
          get_logger(),
          "Got request to turn %s chained mode for controller '%s', but controller refused "
          "to do it! The control will probably not work as expected. Try to restart all "
          "controllers. If the error persist check controllers' individual configuration.",
          to_chained_mode ? "ON" : "OFF", name.c_str());
    }
  }
}

bool ControllerManager::claim_interfaces(ControllerSpec& spec) {
  std::vector<hardware_interface::LoanedCommandInterface> commands;
  std::vector<hardware_interface::LoanedStateInterface> states;
  const char* kind = "command";
  try {
    spec.info.claimed_interfaces = names_of(spec.c->command_interface_configuration(),
                                            resource_manager_->available_command_interfaces());
    for (const std::string& name : spec.info.claimed_interfaces) {
      if (resource_manager_->command_interface_is_claimed(name)) {
        RCLCPP_ERROR(get_logger(),
                     "Resource conflict for controller '%s'. Command interface '%s' is already "
                     "claimed.",
                     spec.info.name.c_str(), name.c_str());
        return false;
      }
      commands.push_back(resource_manager_->claim_command_interface(name));
    }
    kind = "state";
    for (const std::string& name : names_of(spec.c->state_interface_configuration(),
                                            resource_manager_->available_state_interfaces())) {
      states.push_back(resource_manager_->claim_state_interface(name));
    }
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(),
                 "Caught exception of type : %s while claiming the %s interfaces. Can't activate "
                 "controller '%s': %s",
                 typeid(error).name(), kind, spec.info.name.c_str(), error.what());
    return false;
  }
  spec.c->assign_interfaces(std::move(commands), std::move(states));
  return true;
}

bool ControllerManager::activate_one(ControllerSpec& spec) {
  const std::string& name = spec.info.name;
  if (!claim_interfaces(spec)) {
    spec.info.claimed_interfaces.clear();
    return false;
  }
  *spec.last_update_cycle_time = rclcpp::Time(0, 0, RCL_CLOCK_UNINITIALIZED);
  try {
    const auto& after = spec.c->get_node()->activate();
    if (after.id() == State::PRIMARY_STATE_ACTIVE) {
      return true;
    }
    RCLCPP_ERROR(get_logger(),
                 "After activation, controller '%s' is in state '%s' (%d), expected '%s' (%d). "
                 "Releasing interfaces!",
                 name.c_str(), after.label().c_str(), after.id(),
                 hardware_interface::lifecycle_state_names::ACTIVE, State::PRIMARY_STATE_ACTIVE);
  } catch (const std::exception& error) {
    RCLCPP_ERROR(get_logger(),
                 "Caught exception of type : %s while activating the controller '%s': %s",
                 typeid(error).name(), name.c_str(), error.what());
    if (!handle_exceptions_) {
      throw;
    }
  }
  spec.c->release_interfaces();
  spec.info.claimed_interfaces.clear();
  return false;
}

void ControllerManager::activate_controllers(
    const std::vector<std::string>& controllers_to_activate, int strictness) {
  std::vector<std::string> done;
  bool failed = false;
  for (const std::string& name : controllers_to_activate) {
    const ControllerSpec* const spec = find_controller(name);
    if (spec != nullptr && spec->c->is_chainable()) {
      resource_manager_->make_controller_exported_state_interfaces_available(name);
      resource_manager_->make_controller_reference_interfaces_available(name);
    }
  }
  for (const std::string& name : controllers_to_activate) {
    ControllerSpec* const spec = find_controller(name);
    if (spec == nullptr) {
      continue;
    }
    if (activate_one(*spec)) {
      done.push_back(name);
      continue;
    }
    failed = true;
    if (spec->c->is_chainable()) {
      resource_manager_->make_controller_exported_state_interfaces_unavailable(name);
      resource_manager_->make_controller_reference_interfaces_unavailable(name);
    }
  }
  if (!failed) {
    return;
  }
  std::vector<std::string> to_stop = commands_of(controllers_to_activate);
  if (strictness == Switch::STRICT) {
    RCLCPP_ERROR(get_logger(),
                 "At least one controller failed to be activated. Releasing all interfaces and "
                 "stopping all activated controllers because the switch strictness is set to "
                 "STRICT.");
    deactivate_controllers(done);
  } else {
    for (const std::string& name : commands_of(done)) {
      std::ignore = ros2_control::remove_item(to_stop, name);
    }
  }
  if (!to_stop.empty() && !(resource_manager_->prepare_command_mode_switch({}, to_stop) &&
                            resource_manager_->perform_command_mode_switch({}, to_stop))) {
    RCLCPP_ERROR(get_logger(),
                 "Error switching back the interfaces in the hardware when the controller "
                 "activation failed.");
  }
}

std::vector<std::string> ControllerManager::commands_of(
    const std::vector<std::string>& controllers) {
  std::vector<std::string> result;
  for (const std::string& name : controllers) {
    const ControllerSpec* const spec = find_controller(name);
    if (spec != nullptr) {
      ros2_control::add_items(result, names_of(spec->c->command_interface_configuration(),
                                               resource_manager_->available_command_interfaces()));
    }
  }
  return result;
}

}  // namespace controller_manager
