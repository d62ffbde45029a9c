// Text with one part of it replaced wherever it stands. Pure.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

/// `text` with `to` for every `from`, from left to right; what was put in is not looked at again.
/// An empty `from` stands nowhere.
[[nodiscard]] std::string with_replaced(std::string_view text, std::string_view from,
                                        std::string_view to);

}  // namespace ros2wasm
