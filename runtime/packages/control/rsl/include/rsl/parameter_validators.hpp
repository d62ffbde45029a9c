// Checks of a parameter's value: nothing when it holds, else the reason for refusing it. `T` is the
// type of the value, or that of its elements for an array. A parameter of another type throws
// rclcpp::exceptions::InvalidParameterTypeException.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/parameter.hpp"
#include "ros2wasm_parameters/refusals.hpp"
#include "rsl/algorithm.hpp"
#include "rsl/static_string.hpp"
#include "rsl/static_vector.hpp"
#include "tl/expected.hpp"

namespace rsl {

/// As `validation:` of a parameter file wants its functions to return.
using ValidatorResult = tl::expected<void, std::string>;

namespace detail {

template <class T>
size_t length_of(const rclcpp::Parameter& parameter) {
  return parameter.get_type() == rclcpp::ParameterType::PARAMETER_STRING
             ? parameter.as_string().size()
             : parameter.get_value<std::vector<T>>().size();
}

template <class T, class RelationT>
ValidatorResult compare(const rclcpp::Parameter& parameter, const T& bound, const char* must,
                        const RelationT& relation) {
  const T value = parameter.get_value<T>();
  if (relation(value, bound)) return {};
  return tl::make_unexpected(
      ros2wasm_parameters::refused(parameter.get_name(), value, must, bound));
}

template <class T, class RelationT>
ValidatorResult compare_length(const rclcpp::Parameter& parameter, size_t bound, const char* must,
                               const RelationT& relation) {
  const size_t length = length_of<T>(parameter);
  if (relation(length, bound)) return {};
  return tl::make_unexpected(
      ros2wasm_parameters::length_refused(parameter.get_name(), length, must, bound));
}

}  // namespace detail

template <class T>
[[nodiscard]] ValidatorResult lt(const rclcpp::Parameter& parameter, const T& bound) {
  return detail::compare<T>(parameter, bound, "less than", std::less<T>());
}

template <class T>
[[nodiscard]] ValidatorResult gt(const rclcpp::Parameter& parameter, const T& bound) {
  return detail::compare<T>(parameter, bound, "greater than", std::greater<T>());
}

template <class T>
[[nodiscard]] ValidatorResult lt_eq(const rclcpp::Parameter& parameter, const T& bound) {
  return detail::compare<T>(parameter, bound, "less than or equal to", std::less_equal<T>());
}

template <class T>
[[nodiscard]] ValidatorResult gt_eq(const rclcpp::Parameter& parameter, const T& bound) {
  return detail::compare<T>(parameter, bound, "greater than or equal to", std::greater_equal<T>());
}

/// Older name of lt_eq(), with another text.
template <class T>
[[nodiscard]] ValidatorResult upper_bounds(const rclcpp::Parameter& parameter, const T& bound) {
  return detail::compare<T>(parameter, bound, "below upper bound of", std::less_equal<T>());
}

/// Older name of gt_eq(), with another text.
template <class T>
[[nodiscard]] ValidatorResult lower_bounds(const rclcpp::Parameter& parameter, const T& bound) {
  return detail::compare<T>(parameter, bound, "above lower bound of", std::greater_equal<T>());
}

/// Both ends are part of the bounds. NaN is refused nowhere.
template <class T>
[[nodiscard]] ValidatorResult bounds(const rclcpp::Parameter& parameter, const T& lower,
                                     const T& upper) {
  const T value = parameter.get_value<T>();
  if (!(value < lower || value > upper)) return {};
  return tl::make_unexpected(
      ros2wasm_parameters::out_of_bounds(parameter.get_name(), value, lower, upper));
}

template <class T>
[[nodiscard]] ValidatorResult one_of(const rclcpp::Parameter& parameter,
                                     const std::vector<T>& set) {
  const T value = parameter.get_value<T>();
  if (contains(set, value)) return {};
  return tl::make_unexpected(ros2wasm_parameters::not_in_set(parameter.get_name(), value, set));
}

template <class T>
[[nodiscard]] ValidatorResult unique(const rclcpp::Parameter& parameter) {
  if (is_unique(std::vector<T>(parameter.get_value<std::vector<T>>()))) return {};
  return tl::make_unexpected(ros2wasm_parameters::repeated_refused(parameter.get_name()));
}

template <class T>
[[nodiscard]] ValidatorResult subset_of(const rclcpp::Parameter& parameter,
                                        const std::vector<T>& set) {
  for (const T& value : parameter.get_value<std::vector<T>>()) {
    if (!contains(set, value))
      return tl::make_unexpected(
          ros2wasm_parameters::entry_not_in_set(parameter.get_name(), value, set));
  }
  return {};
}

/// The length of an array or a text, likewise for the next three.
template <class T>
[[nodiscard]] ValidatorResult fixed_size(const rclcpp::Parameter& parameter, size_t length) {
  return detail::compare_length<T>(parameter, length, "equal to", std::equal_to<>());
}

template <class T>
[[nodiscard]] ValidatorResult size_gt(const rclcpp::Parameter& parameter, size_t length) {
  return detail::compare_length<T>(parameter, length, "greater than", std::greater<>());
}

template <class T>
[[nodiscard]] ValidatorResult size_lt(const rclcpp::Parameter& parameter, size_t length) {
  return detail::compare_length<T>(parameter, length, "less than", std::less<>());
}

template <class T>
[[nodiscard]] ValidatorResult not_empty(const rclcpp::Parameter& parameter) {
  if (detail::length_of<T>(parameter) > 0) return {};
  return tl::make_unexpected(ros2wasm_parameters::empty_refused(parameter.get_name()));
}

template <class T>
[[nodiscard]] ValidatorResult element_bounds(const rclcpp::Parameter& parameter, const T& lower,
                                             const T& upper) {
  for (const T& value : parameter.get_value<std::vector<T>>()) {
    if (value < lower || value > upper)
      return tl::make_unexpected(
          ros2wasm_parameters::element_out_of_bounds(parameter.get_name(), value, lower, upper));
  }
  return {};
}

template <class T>
[[nodiscard]] ValidatorResult lower_element_bounds(const rclcpp::Parameter& parameter,
                                                   const T& lower) {
  for (const T& value : parameter.get_value<std::vector<T>>()) {
    if (value < lower)
      return tl::make_unexpected(ros2wasm_parameters::element_refused(
          parameter.get_name(), value, "above lower bound of", lower));
  }
  return {};
}

template <class T>
[[nodiscard]] ValidatorResult upper_element_bounds(const rclcpp::Parameter& parameter,
                                                   const T& upper) {
  for (const T& value : parameter.get_value<std::vector<T>>()) {
    if (value > upper)
      return tl::make_unexpected(ros2wasm_parameters::element_refused(
          parameter.get_name(), value, "below upper bound of", upper));
  }
  return {};
}

/// The answer of a callback for new values.
[[nodiscard]] inline rcl_interfaces::msg::SetParametersResult to_parameter_result_msg(
    const ValidatorResult& result) {
  rcl_interfaces::msg::SetParametersResult message;
  message.successful = result.has_value();
  if (!result) message.reason = result.error();
  return message;
}

}  // namespace rsl
