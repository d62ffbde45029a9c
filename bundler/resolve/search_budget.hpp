// How long a search may go on. Counted, not timed: the same request ends the same way everywhere.
#pragma once

#include <cstddef>

#include "workspace_schema/base/cancellation.hpp"

namespace ros2wasm {

/// No package of a real channel of 4,211 records takes 1,000, and all but one take 100 at most.
inline constexpr std::size_t kMostContradictions = 100'000;

struct SearchBudget {
  Cancellation cancellation{};
  std::size_t most_contradictions = kMostContradictions;
};

}  // namespace ros2wasm
