// Which interfaces there are, whether they can be used, and which commands are claimed. All lists
// are sorted by name. This file needs no ROS; locking is the caller's.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "hardware_interface/handle.hpp"

namespace hardware_interface {

class InterfaceLedger {
 public:
  /// Throw std::runtime_error for a name that exists.
  void add(const StateInterface::ConstSharedPtr& interface);
  void add(const CommandInterface::SharedPtr& interface);
  void remove_states(const std::vector<std::string>& names);
  void remove_commands(const std::vector<std::string>& names);
  void set_states_available(const std::vector<std::string>& names, bool available);
  void set_commands_available(const std::vector<std::string>& names, bool available);

  [[nodiscard]] std::vector<std::string> states() const;
  [[nodiscard]] std::vector<std::string> commands() const;
  [[nodiscard]] std::vector<std::string> available_states() const;
  [[nodiscard]] std::vector<std::string> available_commands() const;
  /// Null when there is none of that name, or it is not available.
  [[nodiscard]] StateInterface::ConstSharedPtr available_state(const std::string& name) const;
  [[nodiscard]] CommandInterface::SharedPtr available_command(const std::string& name) const;
  [[nodiscard]] StateInterface::ConstSharedPtr state(const std::string& name) const;
  [[nodiscard]] CommandInterface::SharedPtr command(const std::string& name) const;
  [[nodiscard]] bool is_claimed(const std::string& name) const;

  /// Throws std::runtime_error for a command that does not exist, is not available or is claimed.
  CommandInterface::SharedPtr claim(const std::string& name);
  void release(const std::string& name);

 private:
  template <typename PointerT>
  struct Entry {
    PointerT interface;
    bool available = false;
    bool claimed = false;
  };
  std::map<std::string, Entry<StateInterface::ConstSharedPtr>> states_;
  std::map<std::string, Entry<CommandInterface::SharedPtr>> commands_;
};

}  // namespace hardware_interface
