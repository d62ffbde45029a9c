// Checks of this package: one in the older form, one in the newer.
#pragma once

#include <numeric>
#include <parameter_traits/parameter_traits.hpp>
#include <rclcpp/rclcpp.hpp>
#include <string>
#include <tl_expected/expected.hpp>
#include <vector>

namespace own_validators {

template <typename T>
parameter_traits::Result is_even(const rclcpp::Parameter& parameter) {
  if (parameter.get_value<T>() % 2 == 0) return parameter_traits::OK;
  return parameter_traits::ERROR("'{}' is odd: {}", parameter.get_name(), parameter.as_int());
}

inline tl::expected<void, std::string> sum_is_below(const rclcpp::Parameter& parameter,
                                                    double most) {
  const std::vector<double>& values = parameter.as_double_array();
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  if (sum < most) return {};
  return tl::make_unexpected(fmt::format("the sum of '{}' is {}", parameter.get_name(), sum));
}

}  // namespace own_validators
