// YAML as xacro's expressions see it: values typed by YAML 1.1, dictionaries whose keys are
// attributes too, numbers with units. Pure.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "bundler/launch/python/python_value.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// `calculated`: what the expression behind a unit such as `!degrees` comes to. Its faults go
/// through, others are PythonFault. Outcome: the faults of the file itself.
[[nodiscard]] Outcome<PythonValue> read_xacro_yaml(
    std::string_view text, const std::string& shown,
    const std::function<PythonValue(const std::string& expression)>& calculated);

/// The same value, with keys that are attributes in all dictionaries.
[[nodiscard]] PythonValue python_dotted(const PythonValue& value);

}  // namespace ros2wasm
