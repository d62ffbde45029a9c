// Values that parameters get from outside: parameter files, -p, and node options.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/parameter.hpp"

namespace rclcpp {
namespace detail {

/// Overrides of one node, the later and more explicit winning: global arguments, local arguments,
/// options. Throws RCLError for a file that cannot be read or understood.
std::map<std::string, rclcpp::ParameterValue> resolve_parameter_overrides(
    const node_interfaces::NodeBaseInterface& node,
    const std::vector<rclcpp::Parameter>& option_overrides);

}  // namespace detail
}  // namespace rclcpp
