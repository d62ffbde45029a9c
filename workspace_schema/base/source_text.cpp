// See source_text.hpp.
#include "workspace_schema/base/source_text.hpp"

#include <algorithm>

namespace ros2wasm {
namespace {

/// A span carries its line along; a line longer than this is cut (the caret is then only near the
/// place).
constexpr std::size_t kLongestLine = 4096;

}  // namespace

SourceText::SourceText(std::string_view text, std::string file)
    : text_(text), file_(std::move(file)) {
  starts_.push_back(0);
  for (std::size_t i = 0; i < text_.size(); ++i) {
    if (text_[i] == '\n') starts_.push_back(i + 1);
  }
}

std::size_t SourceText::line_start(std::size_t line) const {
  if (line == 0) return 0;
  return line <= starts_.size() ? starts_[line - 1] : text_.size();
}

std::string_view SourceText::line_text(std::size_t line) const {
  const std::size_t start = line_start(line);
  const std::size_t end = std::min(text_.find('\n', start), text_.size());
  std::string_view found = text_.substr(start, end - start);
  if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
  return found;
}

SourceSpan SourceText::span(std::size_t offset, std::size_t length) const {
  offset = std::min(offset, text_.size());
  const auto after = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto line = static_cast<std::size_t>(after - starts_.begin());
  const std::string_view whole = line_text(line);
  const std::size_t column = offset - line_start(line);
  const std::size_t room = whole.size() > column ? whole.size() - column : 0;
  return SourceSpan{.file = file_,
                    .line = static_cast<std::uint32_t>(line),
                    .column = static_cast<std::uint32_t>(column + 1),
                    .length = static_cast<std::uint32_t>(std::min(length, room)),
                    .line_text = std::string(whole.substr(0, kLongestLine))};
}

}  // namespace ros2wasm
