// Checks for files of parameters (generate_parameter_library, whose targets have what this
// includes): the third argument of packages whose limits may be NaN, which means that there is
// none.
#pragma once

#include <cmath>
#include <string>

#include "rclcpp/parameter.hpp"
#include "rsl/parameter_validators.hpp"
#include "tl/expected.hpp"

namespace control_filters {

template <typename T>
tl::expected<void, std::string> gt_eq_or_nan(const rclcpp::Parameter& parameter, T bound) {
  if (std::isnan(parameter.as_double())) return {};
  return rsl::gt_eq<T>(parameter, bound);
}

template <typename T>
tl::expected<void, std::string> lt_eq_or_nan(const rclcpp::Parameter& parameter, T bound) {
  if (std::isnan(parameter.as_double())) return {};
  return rsl::lt_eq<T>(parameter, bound);
}

}  // namespace control_filters
