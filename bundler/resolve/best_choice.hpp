// The solution that the documented order prefers among all solutions (docs/solving.md). Pure.
#pragma once

#include <optional>
#include <vector>

#include "bundler/resolve/search_budget.hpp"
#include "bundler/resolve/universe.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Candidates that are chosen, in ascending order.
using Choice = std::vector<CandidateId>;

/// The candidates that are needed and no others; nothing where nothing fits. R2W0305 the budget did
/// not last, R2W0903.
[[nodiscard]] Outcome<std::optional<Choice>> best_choice(const Universe& universe,
                                                         const SearchBudget& budget);

}  // namespace ros2wasm
