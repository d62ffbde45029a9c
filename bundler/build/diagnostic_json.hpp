// Diagnostics as JSON: how the link driver, a grandchild of the pack, hands its findings up. Pure.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

[[nodiscard]] std::string diagnostics_to_json(const Diagnostics& diagnostics);

/// What is not such JSON yields nothing.
[[nodiscard]] Diagnostics diagnostics_from_json(std::string_view text);

}  // namespace ros2wasm
