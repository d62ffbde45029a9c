// Texts that are part of the program, embedded at build time by embed_texts.cmake.
#pragma once

#include <span>
#include <string_view>

namespace ros2wasm {

struct EmbeddedText {
  std::string_view name;  ///< of the file, up to its first dot
  std::string_view text;
};

/// cli/explain/: name is the code; the first line of the text is `# CODE: title`. Sorted by name.
[[nodiscard]] std::span<const EmbeddedText> explain_pages();

/// workspace_schema/schemas/: "course", "events" and "workspace". Sorted by name.
[[nodiscard]] std::span<const EmbeddedText> json_schemas();

}  // namespace ros2wasm
