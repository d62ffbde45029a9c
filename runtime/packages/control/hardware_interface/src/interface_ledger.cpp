// Names, availability and claims of interfaces.
#include "interface_ledger.hpp"

#include <stdexcept>

namespace hardware_interface {
namespace {

template <typename MapT>
std::vector<std::string> names_of(const MapT& entries, bool only_available) {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries) {
    if (entry.available || !only_available) {
      names.push_back(name);
    }
  }
  return names;
}

template <typename MapT>
void set_available(MapT& entries, const std::vector<std::string>& names, bool available) {
  for (const std::string& name : names) {
    const auto found = entries.find(name);
    if (found != entries.end()) {
      found->second.available = available;
    }
  }
}

template <typename MapT>
auto find_in(const MapT& entries, const std::string& name, bool only_available) {
  const auto found = entries.find(name);
  const bool usable = found != entries.end() && (found->second.available || !only_available);
  return usable ? found->second.interface : decltype(found->second.interface)();
}

}  // namespace

void InterfaceLedger::add(const StateInterface::ConstSharedPtr& interface) {
  if (!states_.emplace(interface->get_name(), Entry<StateInterface::ConstSharedPtr>{interface})
           .second) {
    throw std::runtime_error(
        "ResourceStorage: Tried to insert StateInterface with already existing key. Insert[" +
        interface->get_name() + "]");
  }
}
void InterfaceLedger::add(const CommandInterface::SharedPtr& interface) {
  if (!commands_.emplace(interface->get_name(), Entry<CommandInterface::SharedPtr>{interface})
           .second) {
    throw std::runtime_error(
        "ResourceStorage: Tried to insert CommandInterface with already existing key. Insert[" +
        interface->get_name() + "]");
  }
}

void InterfaceLedger::remove_states(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    states_.erase(name);
  }
}
void InterfaceLedger::remove_commands(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    commands_.erase(name);
  }
}
void InterfaceLedger::set_states_available(const std::vector<std::string>& names, bool available) {
  set_available(states_, names, available);
}
void InterfaceLedger::set_commands_available(const std::vector<std::string>& names,
                                             bool available) {
  set_available(commands_, names, available);
}

std::vector<std::string> InterfaceLedger::states() const {
  return names_of(states_, false);
}
std::vector<std::string> InterfaceLedger::commands() const {
  return names_of(commands_, false);
}
std::vector<std::string> InterfaceLedger::available_states() const {
  return names_of(states_, true);
}
std::vector<std::string> InterfaceLedger::available_commands() const {
  return names_of(commands_, true);
}
StateInterface::ConstSharedPtr InterfaceLedger::available_state(const std::string& name) const {
  return find_in(states_, name, true);
}
CommandInterface::SharedPtr InterfaceLedger::available_command(const std::string& name) const {
  return find_in(commands_, name, true);
}
StateInterface::ConstSharedPtr InterfaceLedger::state(const std::string& name) const {
  return find_in(states_, name, false);
}
CommandInterface::SharedPtr InterfaceLedger::command(const std::string& name) const {
  return find_in(commands_, name, false);
}
bool InterfaceLedger::is_claimed(const std::string& name) const {
  const auto found = commands_.find(name);
  return found != commands_.end() && found->second.available && found->second.claimed;
}

CommandInterface::SharedPtr InterfaceLedger::claim(const std::string& name) {
  const auto found = commands_.find(name);
  if (found == commands_.end() || !found->second.available) {
    throw std::runtime_error("Command interface with key '" + name + "' does not exist");
  }
  if (found->second.claimed) {
    throw std::runtime_error("Command interface with key '" + name + "' is already claimed");
  }
  found->second.claimed = true;
  return found->second.interface;
}

void InterfaceLedger::release(const std::string& name) {
  const auto found = commands_.find(name);
  if (found != commands_.end()) {
    found->second.claimed = false;
  }
}

}  // namespace hardware_interface
