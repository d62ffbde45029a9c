// YAML of long lists that programs maintain, such as distribution files. Apart from
// yaml_reader.hpp, whose limit holds for what people write.
#pragma once

#include "workspace_schema/base/yaml_reader.hpp"

namespace ros2wasm {

/// As parse_yaml(), for ten times as many values; of two keys the last counts.
[[nodiscard]] Outcome<YamlDocument> parse_long_yaml(const SourceText& source);

}  // namespace ros2wasm
