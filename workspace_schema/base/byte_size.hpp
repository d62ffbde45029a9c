// Sizes with their unit, as people write them: `12 MB`, `1.5 MiB`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// In bytes. A number with at most three digits behind its point, then B, kB, MB, GB (thousands) or
/// KiB, MiB, GiB (1024), with a space between them or none. Nothing for everything else.
[[nodiscard]] std::optional<std::uint64_t> parse_byte_size(std::string_view text);

/// The spelling that parse_byte_size() takes for a text with other letters, such as `12 mb` or
/// `12M`.
[[nodiscard]] std::optional<std::string> meant_byte_size(std::string_view text);

/// With the largest unit of thousands that it reaches and two digits: `12.34 MB`, `999 B`.
[[nodiscard]] std::string byte_size_text(std::uint64_t bytes);

}  // namespace ros2wasm
