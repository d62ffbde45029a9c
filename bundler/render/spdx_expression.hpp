// License statements of packages as SPDX license expressions. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// `text` as an expression of identifiers that SPDX has, as far as they are common among the
/// packages of ROS, conda and npm: also words that people use for one of them (`Apache
/// License 2.0`). Nothing for others, such as `BSD`, which does not say which one.
[[nodiscard]] std::optional<std::string> spdx_expression(std::string_view text);

/// Whether it is one identifier, without operators.
[[nodiscard]] bool is_spdx_identifier(std::string_view text);

}  // namespace ros2wasm
