// How values in launch files get their types. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "bundler/launch/launch_entity.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// A single value as text; nothing for a list.
[[nodiscard]] std::optional<std::string> launch_value_text(const LaunchAttributeValue& value);

/// true, false, 1, 0, on, off, yes, no in any case.
[[nodiscard]] std::optional<bool> launch_boolean(std::string_view text);

/// The value of a parameter's text: as YAML reads it when `type` is empty, else as bool, int,
/// float, str or a list_of_ one of these. A list in `text` is YAML, or has `separator` between its
/// items. R2W0410.
[[nodiscard]] Outcome<ParameterValue> typed_parameter(const std::string& text,
                                                      const std::string& type,
                                                      const std::string& separator,
                                                      const SourceSpan& span);

/// A list of values of one type; whole numbers among others become those. Nothing when the types
/// differ.
[[nodiscard]] std::optional<ParameterValue> list_parameter(
    const std::vector<ParameterValue>& items);

}  // namespace ros2wasm
