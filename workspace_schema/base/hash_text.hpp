// Hashes as texts.
#pragma once

#include <string_view>

namespace ros2wasm {

/// A sha256: 64 hexadecimal digits in lower case.
[[nodiscard]] constexpr bool is_sha256_text(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace ros2wasm
