// A text file in memory with its lines, so that byte offsets become places that people can find.
// Pure.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"

namespace ros2wasm {

/// Does not own the text: it must outlive this.
class SourceText {
 public:
  SourceText(std::string_view text, std::string file);

  /// The place of the bytes [offset, offset + length); cut at the end of the line where it begins.
  [[nodiscard]] SourceSpan span(std::size_t offset, std::size_t length) const;

  /// Offset of the first byte of a line, counted from 1; the text's size for lines behind the end.
  [[nodiscard]] std::size_t line_start(std::size_t line) const;

  /// The line without its newline (and without a carriage return before it).
  [[nodiscard]] std::string_view line_text(std::size_t line) const;

  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string_view text_;
  std::string file_;
  std::vector<std::size_t> starts_;  ///< offset of each line
};

}  // namespace ros2wasm
