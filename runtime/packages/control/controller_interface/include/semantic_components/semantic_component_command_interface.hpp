// A group of command interfaces that belong together, such as the colours of a lamp.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller_interface/helpers.hpp"
#include "hardware_interface/loaned_command_interface.hpp"

namespace semantic_components {

template <typename MessageInputType>
class SemanticComponentCommandInterface {
 public:
  SemanticComponentCommandInterface(const std::string& name,
                                    const std::vector<std::string>& interface_names)
      : name_(name), interface_names_(interface_names) {
    command_interfaces_.reserve(interface_names.size());
  }
  virtual ~SemanticComponentCommandInterface() = default;

  bool assign_loaned_command_interfaces(
      std::vector<hardware_interface::LoanedCommandInterface>& command_interfaces) {
    return controller_interface::get_ordered_interfaces(command_interfaces, interface_names_, "",
                                                        command_interfaces_);
  }
  void release_interfaces() { command_interfaces_.clear(); }
  const std::vector<std::string>& get_command_interface_names() const { return interface_names_; }

  /// False for another number of values, or when one could not be set.
  bool set_values(const std::vector<double>& values) {
    bool all_set = values.size() == command_interfaces_.size();
    for (std::size_t i = 0; all_set && i < values.size(); ++i) {
      all_set = command_interfaces_[i].get().set_value(values[i]);
    }
    return all_set;
  }
  virtual bool set_values_from_message(const MessageInputType& message) = 0;

 protected:
  std::string name_;
  std::vector<std::string> interface_names_;
  std::vector<std::reference_wrapper<hardware_interface::LoanedCommandInterface>>
      command_interfaces_;
};

}  // namespace semantic_components
