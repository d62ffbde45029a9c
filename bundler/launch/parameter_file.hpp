// ROS 2 parameter files (`/node: ros__parameters: {...}`) as rules. Pure: text in, rules out.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/launch/node_arguments.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/yaml_reader.hpp"

namespace ros2wasm {

/// Rules in the order of the file. Nested keys are joined by dots, nested namespaces by slashes, as
/// rcl does. R2W0403 not YAML, or not a parameter file (with line and column).
[[nodiscard]] Outcome<std::vector<ParameterRule>> read_parameter_file(std::string_view text,
                                                                      const std::string& file);

/// One value; nothing is an empty text. Nothing comes back for what no parameter can be.
[[nodiscard]] std::optional<ParameterValue> parameter_value(const YamlNode& node);

}  // namespace ros2wasm
