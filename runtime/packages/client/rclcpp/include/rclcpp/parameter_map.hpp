// Parameters of several nodes, as a parameter file has them.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "rclcpp/parameter.hpp"

namespace rclcpp {

/// Node name (as the file writes it) to its parameters.
using ParameterMap = std::unordered_map<std::string, std::vector<Parameter>>;

/// Throws RCLError for a file that cannot be read or understood. With `node_fqn`, only what means
/// that node.
ParameterMap parameter_map_from_yaml_file(const std::string& yaml_filename,
                                          const char* node_fqn = nullptr);
std::vector<Parameter> parameters_from_map(const ParameterMap& parameter_map,
                                           const char* node_fqn = nullptr);

}  // namespace rclcpp
