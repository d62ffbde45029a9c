// Names of nodes, and parameters that several parts of a server declare.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "rcl_interfaces/srv/list_parameters.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_util {

/// Characters other than letters and digits become `_`.
std::string sanitize_node_name(const std::string& potential_node_name);
/// The absolute namespace of one below another.
std::string add_namespaces(const std::string& top_ns, const std::string& sub_ns = "");
/// The prefix, `_` and eight digits.
std::string generate_internal_node_name(const std::string& prefix = "");
/// A node of that name without services and events of parameters.
rclcpp::Node::SharedPtr generate_internal_node(const std::string& prefix = "");
/// The last `len` digits of the time in nanoseconds.
std::string time_to_string(size_t len);

using ParameterDescriptor = rcl_interfaces::msg::ParameterDescriptor;
using NodeParamInterfacePtr = rclcpp::node_interfaces::NodeParametersInterface::SharedPtr;

template <typename NodeT>
void declare_parameter_if_not_declared(
    NodeT node, const std::string& parameter_name, const rclcpp::ParameterValue& default_value,
    const ParameterDescriptor& parameter_descriptor = ParameterDescriptor()) {
  if (!node->has_parameter(parameter_name)) {
    node->declare_parameter(parameter_name, default_value, parameter_descriptor);
  }
}

template <typename NodeT>
void declare_parameter_if_not_declared(
    NodeT node, const std::string& parameter_name, const rclcpp::ParameterType& param_type,
    const ParameterDescriptor& parameter_descriptor = ParameterDescriptor()) {
  if (!node->has_parameter(parameter_name)) {
    node->declare_parameter(parameter_name, param_type, parameter_descriptor);
  }
}

/// Throws InvalidParameterValueException when nothing sets it.
template <typename ParameterT, typename NodeT>
ParameterT declare_or_get_parameter(
    NodeT node, const std::string& parameter_name, const rclcpp::ParameterType& param_type,
    const ParameterDescriptor& parameter_descriptor = ParameterDescriptor()) {
  if (node->has_parameter(parameter_name)) {
    return node->get_parameter(parameter_name).template get_value<ParameterT>();
  }
  const auto value = node->declare_parameter(parameter_name, param_type, parameter_descriptor);
  if (value.get_type() == rclcpp::ParameterType::PARAMETER_NOT_SET) {
    throw rclcpp::exceptions::InvalidParameterValueException("Parameter " + parameter_name +
                                                             " not in overrides");
  }
  return value.template get<ParameterT>();
}

/// For a parameter that nothing sets: a warning, or InvalidParameterValueException.
template <typename ParamType>
ParamType declare_or_get_parameter(
    const rclcpp::Logger& logger, NodeParamInterfacePtr param_interface,
    const std::string& parameter_name, const ParamType& default_value,
    bool warn_if_no_override = false, bool strict_param_loading = false,
    const ParameterDescriptor& parameter_descriptor = ParameterDescriptor()) {
  if (param_interface->has_parameter(parameter_name)) {
    rclcpp::Parameter parameter(parameter_name, default_value);
    param_interface->get_parameter(parameter_name, parameter);
    return parameter.get_value<ParamType>();
  }
  const ParamType value =
      param_interface
          ->declare_parameter(parameter_name, rclcpp::ParameterValue{default_value},
                              parameter_descriptor)
          .template get<ParamType>();
  const auto& overrides = param_interface->get_parameter_overrides();
  if (overrides.find(parameter_name) == overrides.end()) {
    if (warn_if_no_override) {
      RCLCPP_WARN(logger, "Failed to get param %s from overrides, using default value.",
                  parameter_name.c_str());
    }
    if (strict_param_loading) {
      throw rclcpp::exceptions::InvalidParameterValueException(
          "Parameter " + parameter_name + " not in overrides and strict_param_loading is True");
    }
  }
  return value;
}

/// The parameters `warn_on_missing_params` and `strict_param_loading` of the node say what happens
/// when nothing sets it.
template <typename ParamType, typename NodeT>
ParamType declare_or_get_parameter(
    NodeT node, const std::string& parameter_name, const ParamType& default_value,
    const ParameterDescriptor& parameter_descriptor = ParameterDescriptor()) {
  const auto flag = [&node](const std::string& name) {
    declare_parameter_if_not_declared(node, name, rclcpp::ParameterValue(false));
    bool value = false;
    node->get_parameter(name, value);
    return value;
  };
  const bool warns = flag("warn_on_missing_params");
  const bool is_strict = flag("strict_param_loading");
  return declare_or_get_parameter(node->get_logger(), node->get_node_parameters_interface(),
                                  parameter_name, default_value, warns, is_strict,
                                  parameter_descriptor);
}

/// The class of a plugin: the parameter `<plugin_name>.plugin`. Throws std::runtime_error when
/// nothing sets it.
template <typename NodeT>
std::string get_plugin_type_param(NodeT node, const std::string& plugin_name) {
  declare_parameter_if_not_declared(node, plugin_name + ".plugin", rclcpp::PARAMETER_STRING);
  std::string plugin_type;
  try {
    if (!node->get_parameter(plugin_name + ".plugin", plugin_type)) {
      RCLCPP_FATAL(node->get_logger(), "Can not get 'plugin' param value for %s",
                   plugin_name.c_str());
      throw std::runtime_error("No 'plugin' param for param ns!");
    }
  } catch (const rclcpp::exceptions::ParameterUninitializedException&) {
    RCLCPP_FATAL(node->get_logger(), "'plugin' param not defined for %s", plugin_name.c_str());
    throw std::runtime_error("No 'plugin' param for param ns!");
  }
  return plugin_type;
}

/// Logs a warning: threads of a browser have no priorities.
void setSoftRealTimePriority();

}  // namespace nav2_util
