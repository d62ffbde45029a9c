// See python_requirements.hpp.
#include "bundler/workspace/python_requirements.hpp"

#include <algorithm>

#include "workspace_schema/base/source_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kBlanks = " \t\r";

}  // namespace

std::vector<Spanned<std::string>> requirements_of_list(std::string_view text,
                                                       const std::string& file) {
  const SourceText source(text, file);
  std::vector<Spanned<std::string>> found;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string_view line = text.substr(start, end - start);
    line = line.substr(0, std::min(line.find('#'), line.find(" --")));
    const std::size_t first = line.find_first_not_of(kBlanks);
    if (first != std::string_view::npos && line[first] != '-' && line[first] != '.' &&
        line.find("://") == std::string_view::npos) {
      line = line.substr(first, line.find_last_not_of(kBlanks) - first + 1);
      found.push_back(
          {.value = std::string(line), .span = source.span(start + first, line.size())});
    }
    start = end + 1;
  }
  return found;
}

std::vector<Spanned<std::string>> requirements_of_setup(std::string_view text,
                                                        const std::string& file) {
  constexpr std::string_view kKey = "install_requires";
  const SourceText source(text, file);
  std::vector<Spanned<std::string>> found;
  const std::size_t key = text.find(kKey);
  const std::size_t list = key == std::string_view::npos ? key : text.find('[', key);
  if (list == std::string_view::npos) return found;
  const std::size_t end = std::min(text.find(']', list), text.size());
  for (std::size_t at = list + 1; at < end;) {
    const std::size_t quote = text.find_first_of("\"'", at);
    if (quote >= end) break;
    const std::size_t close = text.find(text[quote], quote + 1);
    if (close >= end) break;
    const std::string_view one = text.substr(quote + 1, close - quote - 1);
    found.push_back({.value = std::string(one), .span = source.span(quote + 1, one.size())});
    at = close + 1;
  }
  return found;
}

}  // namespace ros2wasm
