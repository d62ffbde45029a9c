// Text in HTML. Pure.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

/// As text of an element and as value of an attribute in double quotes.
[[nodiscard]] std::string html_text(std::string_view text);

}  // namespace ros2wasm
