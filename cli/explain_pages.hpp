// The pages of cli/explain/, embedded at build time by embed_pages.cmake.
#pragma once

#include <span>
#include <string_view>

namespace ros2wasm {

struct ExplainPage {
  std::string_view code;
  std::string_view text;  ///< Markdown; the first line is `# CODE: title`
};

/// Sorted by code.
[[nodiscard]] std::span<const ExplainPage> explain_pages();

}  // namespace ros2wasm
