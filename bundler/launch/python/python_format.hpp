// How Python writes values into texts: `text % values` and `text.format(...)`. Pure.
#pragma once

#include <string>
#include <string_view>

#include "bundler/launch/python/python_value.hpp"

namespace ros2wasm {

/// `format % values`.
[[nodiscard]] std::string python_percent(std::string_view format, const PythonValue& values);
/// `format.format(...)`.
[[nodiscard]] std::string python_formatted(std::string_view format,
                                           const PythonArguments& arguments);

}  // namespace ros2wasm
