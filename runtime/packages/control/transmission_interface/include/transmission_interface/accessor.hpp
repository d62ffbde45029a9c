// Handles by their names.
#pragma once

#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace transmission_interface {

template <typename T>
std::string to_string(const std::vector<T>& list) {
  std::ostringstream text;
  for (const auto& item : list) {
    text << (text.tellp() > 0 ? ", " : "") << item;
  }
  return "[" + text.str() + "]";
}

/// The names of joints or actuators, each once, sorted.
template <class T>
std::vector<std::string> get_names(const std::vector<T>& handles) {
  std::set<std::string> names;
  for (const T& handle : handles) {
    names.insert(handle.get_prefix_name());
  }
  return {names.begin(), names.end()};
}

/// The handles of one interface that have a value, in the order of `names`.
template <typename T>
std::vector<T> get_ordered_handles(const std::vector<T>& unordered_handles,
                                   const std::vector<std::string>& names,
                                   const std::string& interface_type) {
  std::vector<T> result;
  for (const std::string& name : names) {
    for (const T& handle : unordered_handles) {
      if (handle && handle.get_prefix_name() == name &&
          handle.get_interface_name() == interface_type) {
        result.push_back(handle);
      }
    }
  }
  return result;
}

}  // namespace transmission_interface
