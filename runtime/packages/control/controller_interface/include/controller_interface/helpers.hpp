// Interfaces in the order that a controller wants.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "hardware_interface/helpers.hpp"

namespace controller_interface {

/// Finds, for each name in turn, the interface `name/interface_type`; without a type the names are
/// full names. False when not exactly one was found for each.
template <typename T>
bool get_ordered_interfaces(std::vector<T>& unordered_interfaces,
                            const std::vector<std::string>& ordered_names,
                            const std::string& interface_type,
                            std::vector<std::reference_wrapper<T>>& ordered_interfaces) {
  ordered_interfaces.reserve(ordered_names.size());
  for (const std::string& name : ordered_names) {
    const std::string wanted = interface_type.empty() ? name : name + "/" + interface_type;
    for (T& interface : unordered_interfaces) {
      if (interface.get_name() == wanted) {
        ordered_interfaces.push_back(std::ref(interface));
      }
    }
  }
  return ordered_names.size() == ordered_interfaces.size();
}

inline bool interface_list_contains_interface_type(
    const std::vector<std::string>& interface_type_list, const std::string& interface_type) {
  return ros2_control::has_item(interface_type_list, interface_type);
}

template <typename T>
[[deprecated("Use ros2_control::add_item method instead.")]] void add_element_to_list(
    std::vector<T>& list, const T& element) {
  ros2_control::add_item(list, element);
}

}  // namespace controller_interface
