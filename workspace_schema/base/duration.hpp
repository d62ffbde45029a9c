// Durations as people type them: 500ms, 5s, 1.5m. Pure.
#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// A number and its unit (ms, s, m or h), at least 1 ms and at most a week. R2W0621.
[[nodiscard]] Outcome<std::chrono::milliseconds> parse_duration(std::string_view text);

}  // namespace ros2wasm
