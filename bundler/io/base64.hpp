// Base64 (RFC 4648) with padding, without line ends. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

[[nodiscard]] std::string base64(std::string_view bytes);

/// Nothing for a text that base64() does not write.
[[nodiscard]] std::optional<std::string> base64_read(std::string_view text);

}  // namespace ros2wasm
