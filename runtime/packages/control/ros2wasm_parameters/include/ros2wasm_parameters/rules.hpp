// Rules for the value of a parameter. Knows nothing of ROS.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "ros2wasm_parameters/refusals.hpp"

namespace ros2wasm_parameters {

/// A condition, and the range of numbers that it leaves (for the parameter's description).
template <class T>
struct Rule {
  /// Returns the reason why a value of that name is refused, or an empty text.
  std::function<std::string(const std::string& name, const T& value)> check;
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();
};

template <class T = double>
Rule<T> gt(double bound) {
  return {[bound](const std::string& name, const T& value) {
            return static_cast<double>(value) > bound
                       ? std::string()
                       : refused(name, value, "greater than", static_cast<T>(bound));
          },
          bound};
}

template <class T = double>
Rule<T> gt_eq(double bound) {
  return {[bound](const std::string& name, const T& value) {
            return static_cast<double>(value) >= bound
                       ? std::string()
                       : refused(name, value, "greater than or equal to", static_cast<T>(bound));
          },
          bound};
}

template <class T = double>
Rule<T> lt_eq(double bound) {
  return {[bound](const std::string& name, const T& value) {
            return static_cast<double>(value) <= bound
                       ? std::string()
                       : refused(name, value, "less than or equal to", static_cast<T>(bound));
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
                       : out_of_bounds(name, value, static_cast<T>(from), static_cast<T>(to));
          },
          from, to};
}

/// For texts and arrays.
template <class T>
Rule<T> not_empty() {
  return {[](const std::string& name, const T& value) {
    return value.empty() ? empty_refused(name) : std::string();
  }};
}

template <class T>
Rule<T> size_gt(size_t size) {
  return {[size](const std::string& name, const T& value) {
    return value.size() > size ? std::string()
                               : length_refused(name, value.size(), "greater than", size);
  }};
}

template <class T>
Rule<T> size_lt(size_t size) {
  return {[size](const std::string& name, const T& value) {
    return value.size() < size ? std::string()
                               : length_refused(name, value.size(), "less than", size);
  }};
}

template <class T>
Rule<T> fixed_size(size_t size) {
  return {[size](const std::string& name, const T& value) {
    return value.size() == size ? std::string()
                                : length_refused(name, value.size(), "equal to", size);
  }};
}

template <class T>
Rule<T> unique() {
  return {[](const std::string& name, T values) {
    std::sort(values.begin(), values.end());
    return std::adjacent_find(values.begin(), values.end()) == values.end()
               ? std::string()
               : repeated_refused(name);
  }};
}

inline Rule<std::vector<std::string>> subset_of(std::vector<std::string> set) {
  return {[set = std::move(set)](const std::string& name, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
      if (std::find(set.begin(), set.end(), value) == set.end()) {
        return entry_not_in_set(name, value, set);
      }
    }
    return std::string();
  }};
}

inline Rule<std::string> one_of(std::vector<std::string> set) {
  return {[set = std::move(set)](const std::string& name, const std::string& value) {
    return std::find(set.begin(), set.end(), value) != set.end() ? std::string()
                                                                 : not_in_set(name, value, set);
  }};
}

}  // namespace ros2wasm_parameters
