// Of all solutions, the one that the documented order prefers (docs/solving.md). Pure.
#pragma once

#include <variant>

#include "bundler/resolve/sat_engine.hpp"

namespace ros2wasm {

/// Candidates that are chosen, in ascending order.
using Choice = std::vector<CandidateId>;

/// The candidates that are needed and no others, in ascending order. Or, where nothing fits, why.
[[nodiscard]] std::variant<Choice, Proof> best_choice(const Universe& universe);

}  // namespace ros2wasm
