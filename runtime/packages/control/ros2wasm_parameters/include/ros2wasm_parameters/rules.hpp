// Rules for the value of a parameter. The texts are those of generate_parameter_library, so that a
// refused value reads as on a robot. Knows nothing of ROS.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ros2wasm_parameters {

/// A condition, and the range of numbers that it leaves (for the parameter's description).
template <class T>
struct Rule {
  /// Returns the reason why a value of that name is refused, or an empty text.
  std::function<std::string(const std::string& name, const T& value)> check;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

inline std::string text_of(const std::string& value) {
  return value;
}
inline std::string text_of(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

template <class T>
std::string text_of_all(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ", ") + text_of(value);
  return text;
}

/// The refusal of a number that is not as `relation` says, e.g. "less than".
template <class T>
std::string refused(const std::string& name, const T& value, const char* relation, double bound) {
  return "Parameter '" + name + "' with the value '" + text_of(static_cast<double>(value)) +
         "' must be " + relation + " '" + text_of(bound) + "'";
}

template <class T = double>
Rule<T> gt(double bound) {
  return {[bound](const std::string& name, const T& value) {
            return static_cast<double>(value) > bound ? std::string()
                                                      : refused(name, value, "greater than", bound);
          },
          bound};
}

template <class T = double>
Rule<T> gt_eq(double bound) {
  return {[bound](const std::string& name, const T& value) {
            return static_cast<double>(value) >= bound
                       ? std::string()
                       : refused(name, value, "greater than or equal to", bound);
          },
          bound};
}

template <class T = double>
Rule<T> lt_eq(double bound) {
  return {[bound](const std::string& name, const T& value) {
            return static_cast<double>(value) <= bound
                       ? std::string()
                       : refused(name, value, "less than or equal to", bound);
          },
          -std::numeric_limits<double>::infinity(), bound};
}

/// The same, where NaN means that nothing is set.
inline Rule<double> gt_eq_or_nan(double bound) {
  return {[bound](const std::string& name, const double& value) {
    return std::isnan(value) || value >= bound
               ? std::string()
               : refused(name, value, "greater than or equal to", bound);
  }};
}
inline Rule<double> lt_eq_or_nan(double bound) {
  return {[bound](const std::string& name, const double& value) {
    return std::isnan(value) || value <= bound
               ? std::string()
               : refused(name, value, "less than or equal to", bound);
  }};
}

template <class T = double>
Rule<T> bounds(double from, double to) {
  return {[from, to](const std::string& name, const T& value) {
            const double number = static_cast<double>(value);
            return number >= from && number <= to
                       ? std::string()
                       : "Parameter '" + name + "' with the value '" + text_of(number) +
                             "' must be within bounds '[" + text_of(from) + ", " + text_of(to) +
                             "]'";
          },
          from, to};
}

/// For texts and arrays.
template <class T>
Rule<T> not_empty() {
  return {[](const std::string& name, const T& value) {
    return value.empty() ? "Parameter '" + name + "' cannot be empty" : std::string();
  }};
}

template <class T>
Rule<T> size_gt(size_t size) {
  return {[size](const std::string& name, const T& value) {
    return value.size() > size
               ? std::string()
               : "Length of parameter '" + name + "' is '" + std::to_string(value.size()) +
                     "' but must be greater than '" + std::to_string(size) + "'";
  }};
}

template <class T>
Rule<T> size_lt(size_t size) {
  return {[size](const std::string& name, const T& value) {
    return value.size() < size
               ? std::string()
               : "Length of parameter '" + name + "' is '" + std::to_string(value.size()) +
                     "' but must be less than '" + std::to_string(size) + "'";
  }};
}

template <class T>
Rule<T> fixed_size(size_t size) {
  return {[size](const std::string& name, const T& value) {
    return value.size() == size
               ? std::string()
               : "Length of parameter '" + name + "' is '" + std::to_string(value.size()) +
                     "' but must be equal to '" + std::to_string(size) + "'";
  }};
}

template <class T>
Rule<T> unique() {
  return {[](const std::string& name, T values) {
    std::sort(values.begin(), values.end());
    return std::adjacent_find(values.begin(), values.end()) == values.end()
               ? std::string()
               : "Parameter '" + name + "' must only contain unique values";
  }};
}

inline Rule<std::vector<std::string>> subset_of(std::vector<std::string> set) {
  return {[set = std::move(set)](const std::string& name, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
      if (std::find(set.begin(), set.end(), value) == set.end()) {
        return "Entry '" + value + "' in parameter '" + name + "' is not in the set '{" +
               text_of_all(set) + "}'";
      }
    }
    return std::string();
  }};
}

inline Rule<std::string> one_of(std::vector<std::string> set) {
  return {[set = std::move(set)](const std::string& name, const std::string& value) {
    return std::find(set.begin(), set.end(), value) != set.end()
               ? std::string()
               : "Parameter '" + name + "' with the value '" + value + "' is not in the set '{" +
                     text_of_all(set) + "}'";
  }};
}

}  // namespace ros2wasm_parameters
