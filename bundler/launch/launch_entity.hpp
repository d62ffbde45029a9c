// The tree that both frontends build from a launch file: tags with attributes and children, the
// same for XML and YAML. Plain values; nothing is evaluated here.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

using LaunchScalar = std::variant<bool, std::int64_t, double, std::string>;
/// A text is what may hold substitutions; XML has nothing else.
using LaunchAttributeValue =
    std::variant<bool, std::int64_t, double, std::string, std::vector<LaunchScalar>>;

struct LaunchAttribute {
  std::string name;
  LaunchAttributeValue value;
  SourceSpan span;
};

/// One action, or a part of one such as `param` and `remap`.
struct LaunchEntity {
  std::string tag;
  SourceSpan span;
  std::vector<LaunchAttribute> attributes;
  std::vector<LaunchEntity> children;

  [[nodiscard]] const LaunchAttribute* attribute(std::string_view name) const {
    for (const LaunchAttribute& one : attributes)
      if (one.name == name) return &one;
    return nullptr;
  }
};

}  // namespace ros2wasm
