// UTF-8 as the reader and the renderer need it: checking, decoding, width on a terminal. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// One decoded character; `valid` false for a byte that is not part of well-formed UTF-8 (length 1
/// then).
struct Utf8Character {
  char32_t code_point = 0;
  std::size_t length = 1;  ///< bytes
  bool valid = false;
};

/// Decodes the character at `offset` (which must be inside `text`).
[[nodiscard]] Utf8Character decode_utf8(std::string_view text, std::size_t offset);

/// Offset of the first byte that is not well-formed UTF-8.
[[nodiscard]] std::optional<std::size_t> first_invalid_utf8(std::string_view text);

/// Columns that a character takes on a terminal: 0 for combining marks, 2 for wide East Asian and
/// emoji.
[[nodiscard]] std::size_t terminal_width(char32_t code_point);

/// Columns of a whole text without tabs or control characters.
[[nodiscard]] std::size_t terminal_width(std::string_view text);

/// `text` with invalid bytes replaced by U+FFFD.
[[nodiscard]] std::string valid_utf8(std::string_view text);

}  // namespace ros2wasm
