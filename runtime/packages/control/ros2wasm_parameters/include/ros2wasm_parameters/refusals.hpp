// The sentences in which a value of a parameter is refused, which are those of
// generate_parameter_library: a refused value reads as on a robot. Knows nothing of ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

namespace ros2wasm_parameters {

/// Numbers with a fraction have six digits, as in `%g`.
template <class T>
std::string text_of(const T& value) {
  if constexpr (std::is_same_v<T, bool>) {
    return value ? "true" : "false";
  } else if constexpr (std::is_floating_point_v<T>) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", static_cast<double>(value));
    return text;
  } else if constexpr (std::is_integral_v<T>) {
    return std::to_string(value);
  } else {
    return std::string(value);
  }
}

template <class T>
std::string text_of_all(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ", ") + text_of<T>(value);
  return text;
}

/// `must`: the relation that does not hold, e.g. "less than".
template <class T>
std::string refused(const std::string& name, const T& value, const char* must, const T& bound) {
  return "Parameter '" + name + "' with the value '" + text_of(value) + "' must be " + must + " '" +
         text_of(bound) + "'";
}

/// Both ends are part of the bounds.
template <class T>
std::string out_of_bounds(const std::string& name, const T& value, const T& lower, const T& upper) {
  return "Parameter '" + name + "' with the value '" + text_of(value) +
         "' must be within bounds '[" + text_of(lower) + ", " + text_of(upper) + "]'";
}

template <class T>
std::string element_out_of_bounds(const std::string& name, const T& value, const T& lower,
                                  const T& upper) {
  return "Value '" + text_of(value) + "' in parameter '" + name + "' must be within bounds '[" +
         text_of(lower) + ", " + text_of(upper) + "]'";
}

/// `must`: "above lower bound of" or "below upper bound of".
template <class T>
std::string element_refused(const std::string& name, const T& value, const char* must,
                            const T& bound) {
  return "Value '" + text_of(value) + "' in parameter '" + name + "' must be " + must + " '" +
         text_of(bound) + "'";
}

inline std::string length_refused(const std::string& name, size_t length, const char* must,
                                  size_t bound) {
  return "Length of parameter '" + name + "' is '" + std::to_string(length) + "' but must be " +
         must + " '" + std::to_string(bound) + "'";
}

inline std::string empty_refused(const std::string& name) {
  return "Parameter '" + name + "' cannot be empty";
}

inline std::string repeated_refused(const std::string& name) {
  return "Parameter '" + name + "' must only contain unique values";
}

template <class T>
std::string not_in_set(const std::string& name, const T& value, const std::vector<T>& set) {
  return "Parameter '" + name + "' with the value '" + text_of(value) + "' is not in the set '{" +
         text_of_all(set) + "}'";
}

template <class T>
std::string entry_not_in_set(const std::string& name, const T& value, const std::vector<T>& set) {
  return "Entry '" + text_of(value) + "' in parameter '" + name + "' is not in the set '{" +
         text_of_all(set) + "}'";
}

}  // namespace ros2wasm_parameters
