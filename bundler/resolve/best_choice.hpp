// Of all solutions, the one that the documented order prefers (docs/solving.md). Pure.
#pragma once

#include <variant>

#include "bundler/resolve/sat_engine.hpp"

namespace ros2wasm {

/// The candidates that are needed and no others, in ascending order. The answer depends on the
/// universe only, not on how the SAT engine searches.
[[nodiscard]] std::variant<Choice, Proof> best_choice(const Universe& universe);

}  // namespace ros2wasm
