// A diagnostic as text for people, and as JSON. Pure.
#pragma once

#include <cstddef>
#include <string>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

struct TextStyle {
  bool color = false;
  std::size_t width = 100;  ///< longer source lines are cut around the caret
};

/// The form of DESIGN: head, place, source line with caret, `= why:`, `= fix:`, then the detail
/// verbatim. Ends with a newline.
[[nodiscard]] std::string diagnostic_text(const Diagnostic& diagnostic, const TextStyle& style);

/// One JSON object, without newline: the `diagnostic` event of schemas/events.schema.json.
[[nodiscard]] std::string diagnostic_json(const Diagnostic& diagnostic);

}  // namespace ros2wasm
