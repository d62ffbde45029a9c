// The meaning of a YAML scalar: the core schema of YAML 1.2 (null, bool, int, float, text). Pure.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "workspace_schema/base/yaml_reader.hpp"

namespace ros2wasm {

struct YamlIntegerTooLarge {};  ///< written as an integer, but outside of 64 bits
struct YamlUnknownTag {
};  ///< an explicit tag that the core schema has not, or that the text does not fit

using YamlValue = std::variant<std::monostate, bool, std::int64_t, double, std::string,
                               YamlIntegerTooLarge, YamlUnknownTag>;

/// The value of a scalar or null node.
[[nodiscard]] YamlValue scalar_value(const YamlNode& node);

/// How people call what stands there: "a number", "a list", "nothing" ...
[[nodiscard]] std::string_view described(const YamlNode& node);

/// yes, no, on, off (and y, n): texts here, booleans in YAML 1.1, which ROS 2's parameter files
/// follow.
[[nodiscard]] bool is_old_boolean(const YamlNode& node);

/// `text` as one would have to write it so that YAML reads it as this text: as it is, or in double
/// quotes.
[[nodiscard]] std::string as_yaml_text(std::string_view text);

}  // namespace ros2wasm
