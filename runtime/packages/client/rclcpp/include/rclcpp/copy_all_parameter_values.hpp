// Gives a node the parameters of another.
#pragma once

#include <cstddef>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp {

/// Declares what the destination lacks; sets what it has only if asked to. Warns of what it
/// refuses.
template <typename NodeT1, typename NodeT2>
void copy_all_parameter_values(const NodeT1& source, const NodeT2& destination,
                               const bool override_existing_params = false) {
  const auto from = source->get_node_parameters_interface();
  const auto to = destination->get_node_parameters_interface();
  const auto names = from->list_parameters({}, 0).names;
  const auto parameters = from->get_parameters(names);
  const auto descriptors = from->describe_parameters(names);
  const auto warn = [&](const rclcpp::Parameter& parameter, const char* reason) {
    RCLCPP_WARN(destination->get_node_logging_interface()->get_logger(),
                "Unable to set parameter (%s): %s!", parameter.get_name().c_str(), reason);
  };
  for (size_t i = 0; i < parameters.size(); ++i) {
    const rclcpp::Parameter& parameter = parameters[i];
    if (!to->has_parameter(parameter.get_name())) {
      to->declare_parameter(parameter.get_name(), parameter.get_parameter_value(), descriptors[i]);
    } else if (override_existing_params) {
      try {
        const auto result = to->set_parameters_atomically({parameter});
        if (!result.successful) {
          warn(parameter, result.reason.c_str());
        }
      } catch (const rclcpp::exceptions::InvalidParameterTypeException& error) {
        warn(parameter, error.what());
      }
    }
  }
}

}  // namespace rclcpp
