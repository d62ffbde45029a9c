// A group of state interfaces that belong together, such as those of one IMU.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller_interface/helpers.hpp"
#include "hardware_interface/loaned_state_interface.hpp"

namespace semantic_components {

template <typename MessageReturnType>
class SemanticComponentInterface {
 public:
  SemanticComponentInterface(const std::string& name,
                             const std::vector<std::string>& interface_names)
      : name_(name), interface_names_(interface_names) {
    state_interfaces_.reserve(interface_names.size());
  }
  /// The derived class adds its names, or they are name/1, name/2 ...
  explicit SemanticComponentInterface(const std::string& name, std::size_t size = 0) : name_(name) {
    interface_names_.reserve(size);
    state_interfaces_.reserve(size);
  }
  virtual ~SemanticComponentInterface() = default;

  /// False when one of the interfaces is missing.
  bool assign_loaned_state_interfaces(
      std::vector<hardware_interface::LoanedStateInterface>& state_interfaces) {
    return controller_interface::get_ordered_interfaces(state_interfaces, interface_names_, "",
                                                        state_interfaces_);
  }
  void release_interfaces() { state_interfaces_.clear(); }

  virtual std::vector<std::string> get_state_interface_names() {
    if (interface_names_.empty()) {
      for (std::size_t i = 1; i <= interface_names_.capacity(); ++i) {
        interface_names_.emplace_back(name_ + "/" + std::to_string(i));
      }
    }
    return interface_names_;
  }

  /// `values` must have room (its capacity) for exactly the values, which are appended.
  bool get_values(std::vector<double>& values) const {
    if (values.capacity() != state_interfaces_.size()) {
      return false;
    }
    for (const auto& interface : state_interfaces_) {
      values.emplace_back(interface.get().get_optional().value());
    }
    return true;
  }
  bool get_values_as_message(MessageReturnType& /*message*/) { return false; }

 protected:
  /// Copies the values that can be read at once; the others stay as they are.
  template <typename ArrayT>
  void copy_values_into(ArrayT& data) const {
    for (std::size_t i = 0; i < data.size() && i < state_interfaces_.size(); ++i) {
      if (const auto value = state_interfaces_[i].get().get_optional()) {
        data[i] = *value;
      }
    }
  }

  std::string name_;
  std::vector<std::string> interface_names_;
  std::vector<std::reference_wrapper<hardware_interface::LoanedStateInterface>> state_interfaces_;
};

}  // namespace semantic_components
