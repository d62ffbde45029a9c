// A site's `long` has 32 bits, that of the machines ROS 2's code is written for 64. This file knows
// the compiler's messages about that: which of them matter, and what to write instead.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// False for a conversion from 64 bits that loses the same natively (to int), or that only counts
/// objects in memory (to std::size_t): the toolchain asks for these warnings for `long` alone.
[[nodiscard]] bool is_worth_saying(const std::string& message);

/// Adds the reason and the way out to a message of the compiler that the width of `long` is behind.
void explain_long_width(Diagnostic& diagnostic);

}  // namespace ros2wasm
