// "Did you mean": the nearest of the known words by edit distance.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

/// Number of insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);

/// The candidate that `word` was most likely meant to be (letter case and `-`/`_` count little), or
/// nothing when none is near. Ties go to the first candidate.
[[nodiscard]] std::optional<std::string> nearest(std::string_view word,
                                                 std::span<const std::string> candidates);

/// "a, b, c (and 4 more)": at most `limit` names.
[[nodiscard]] std::string name_list(std::span<const std::string> names, std::size_t limit = 6);

}  // namespace ros2wasm
