// Prints the result of a launch file, for people (a tree) and for programs (JSON, docs/launch.md).
// Pure.
#pragma once

#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"
#include "workspace_schema/base/json_writer.hpp"

namespace ros2wasm {

/// Lines without newlines.
[[nodiscard]] std::vector<std::string> launch_tree(const LaunchDescription& description);

/// As it stands in that JSON.
void write_launch_argument(JsonWriter& json, const LaunchArgument& argument);

/// One line of JSON. Times in seconds.
[[nodiscard]] std::string launch_json(const LaunchDescription& description);

}  // namespace ros2wasm
