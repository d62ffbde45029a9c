// The regular expressions of a manifest's checks: what std::regex (ECMAScript) and JavaScript read
// alike, and what cannot take a very long time. Nothing is matched here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// Why a text is not such an expression.
struct PatternFault {
  std::string why;
  std::size_t offset = 0;  ///< of the first byte that is wrong
  std::size_t length = 1;
};

/// Nothing for an expression of characters, `.`, classes, `\d \w \s \b` and their opposites, `^`,
/// `$`, groups, `|` and repetitions, with counts up to 100. Refused, beside what is not an
/// expression: look-around, back-references, repetitions of what repeats or branches ambiguously,
/// which can take a time that grows without bounds, and so many small choices one after the other
/// that all of them together take as long.
[[nodiscard]] std::optional<PatternFault> check_pattern_fault(std::string_view text);

}  // namespace ros2wasm
