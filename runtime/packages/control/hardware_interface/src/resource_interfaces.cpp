// The interfaces of components and controllers, as the resource manager lends them.
#include <stdexcept>
#include <utility>

#include "hardware_interface/helpers.hpp"
#include "hardware_interface/resource_manager.hpp"
#include "resource_storage.hpp"

namespace hardware_interface {

using Lock = std::lock_guard<std::recursive_mutex>;

LoanedStateInterface ResourceManager::claim_state_interface(const std::string& key) {
  const Lock lock(resources_lock_);
  auto state = storage_->ledger.available_state(key);
  if (!state) {
    throw std::runtime_error("State interface with key '" + key + "' does not exist");
  }
  return LoanedStateInterface(state);
}

LoanedCommandInterface ResourceManager::claim_command_interface(const std::string& key) {
  const Lock lock(resources_lock_);
  return LoanedCommandInterface(storage_->ledger.claim(key),
                                [this, key] { release_command_interface(key); });
}

void ResourceManager::release_command_interface(const std::string& key) {
  const Lock lock(resources_lock_);
  storage_->ledger.release(key);
}

std::vector<std::string> ResourceManager::state_interface_keys() const {
  const Lock lock(resources_lock_);
  return storage_->ledger.states();
}
std::vector<std::string> ResourceManager::available_state_interfaces() const {
  const Lock lock(resources_lock_);
  return storage_->ledger.available_states();
}
bool ResourceManager::state_interface_is_available(const std::string& name) const {
  const Lock lock(resources_lock_);
  return storage_->ledger.available_state(name) != nullptr;
}
bool ResourceManager::state_interface_exists(const std::string& key) const {
  const Lock lock(resources_lock_);
  return storage_->ledger.state(key) != nullptr;
}
std::string ResourceManager::get_state_interface_data_type(const std::string& name) const {
  const Lock lock(resources_lock_);
  const auto state = storage_->ledger.state(name);
  return state ? state->get_data_type().to_string() : "unknown";
}
std::vector<std::string> ResourceManager::command_interface_keys() const {
  const Lock lock(resources_lock_);
  return storage_->ledger.commands();
}
std::vector<std::string> ResourceManager::available_command_interfaces() const {
  const Lock lock(resources_lock_);
  return storage_->ledger.available_commands();
}
bool ResourceManager::command_interface_is_available(const std::string& interface) const {
  const Lock lock(resources_lock_);
  return storage_->ledger.available_command(interface) != nullptr;
}
bool ResourceManager::command_interface_is_claimed(const std::string& key) const {
  const Lock lock(resources_lock_);
  return storage_->ledger.is_claimed(key);
}
bool ResourceManager::command_interface_exists(const std::string& key) const {
  const Lock lock(resources_lock_);
  return storage_->ledger.command(key) != nullptr;
}
std::string ResourceManager::get_command_interface_data_type(const std::string& name) const {
  const Lock lock(resources_lock_);
  const auto command = storage_->ledger.command(name);
  return command ? command->get_data_type().to_string() : "unknown";
}

void ResourceManager::import_controller_exported_state_interfaces(
    const std::string& controller_name, std::vector<StateInterface::ConstSharedPtr>& interfaces) {
  const Lock lock(resources_lock_);
  for (const auto& interface : interfaces) {
    storage_->ledger.add(interface);
    storage_->exported_states[controller_name].push_back(interface->get_name());
  }
}
std::vector<std::string> ResourceManager::get_controller_exported_state_interface_names(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  return storage_->exported_states[controller_name];
}
void ResourceManager::make_controller_exported_state_interfaces_available(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  storage_->ledger.set_states_available(storage_->exported_states[controller_name], true);
}
void ResourceManager::make_controller_exported_state_interfaces_unavailable(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  storage_->ledger.set_states_available(storage_->exported_states[controller_name], false);
}
void ResourceManager::remove_controller_exported_state_interfaces(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  storage_->ledger.remove_states(storage_->exported_states[controller_name]);
  storage_->exported_states.erase(controller_name);
}

void ResourceManager::import_controller_reference_interfaces(
    const std::string& controller_name,
    const std::vector<CommandInterface::SharedPtr>& interfaces) {
  const Lock lock(resources_lock_);
  for (const auto& interface : interfaces) {
    storage_->ledger.add(interface);
    storage_->exported_references[controller_name].push_back(interface->get_name());
  }
}
std::vector<std::string> ResourceManager::get_controller_reference_interface_names(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  return storage_->exported_references[controller_name];
}
void ResourceManager::make_controller_reference_interfaces_available(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  storage_->ledger.set_commands_available(storage_->exported_references[controller_name], true);
}
void ResourceManager::make_controller_reference_interfaces_unavailable(
    const std::string& controller_name) {
  const Lock lock(resources_lock_);
  storage_->ledger.set_commands_available(storage_->exported_references[controller_name], false);
}
void ResourceManager::remove_controller_reference_interfaces(const std::string& controller_name) {
  const Lock lock(resources_lock_);
  storage_->ledger.remove_commands(storage_->exported_references[controller_name]);
  storage_->exported_references.erase(controller_name);
}

void ResourceManager::cache_controller_to_hardware(const std::string& controller_name,
                                                   const std::vector<std::string>& interfaces) {
  const Lock lock(resources_lock_);
  for (const auto& [name, info] : storage_->refreshed_infos()) {
    if (ros2_control::has_any_item(info.command_interfaces, interfaces) ||
        ros2_control::has_any_item(info.state_interfaces, interfaces)) {
      ros2_control::add_item(storage_->users[name], controller_name);
    }
  }
}
std::vector<std::string> ResourceManager::get_cached_controllers_to_hardware(
    const std::string& hardware_name) {
  const Lock lock(resources_lock_);
  return storage_->users[hardware_name];
}

}  // namespace hardware_interface
