// See cmake_packages.hpp.
#include "bundler/workspace/cmake_packages.hpp"

#include <algorithm>
#include <cctype>

namespace ros2wasm {
namespace {

constexpr std::string_view kCommand = "find_package";

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '+' ||
         c == '.';
}

/// CMake's commands may be written in capitals.
bool starts_command(std::string_view line, std::size_t at) {
  if (at > 0 && is_name_character(line[at - 1])) return false;
  return std::equal(
      kCommand.begin(), kCommand.end(), line.begin() + static_cast<std::ptrdiff_t>(at),
      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

std::size_t skip_blanks(std::string_view line, std::size_t at) {
  return std::min(line.find_first_not_of(" \t\r", at), line.size());
}

}  // namespace

std::vector<Spanned<std::string>> cmake_packages(std::string_view text, const std::string& file) {
  std::vector<Spanned<std::string>> found;
  std::uint32_t number = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view whole = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    ++number;
    const std::string_view line = whole.substr(0, whole.find('#'));
    for (std::size_t at = 0; at + kCommand.size() < line.size(); ++at) {
      if (!starts_command(line, at)) continue;
      std::size_t first = skip_blanks(line, at + kCommand.size());
      if (first == line.size() || line[first] != '(') continue;
      first = skip_blanks(line, first + 1);
      std::size_t last = first;
      while (last < line.size() && is_name_character(line[last])) ++last;
      const bool is_name = last > first && (last == line.size() || line[last] == ')' ||
                                            line[last] == ' ' || line[last] == '\t');
      const std::string name(line.substr(first, last - first));
      const auto same = [&](const Spanned<std::string>& one) { return one.value == name; };
      if (!is_name || std::any_of(found.begin(), found.end(), same)) continue;
      found.push_back({.value = name,
                       .span = {.file = file,
                                .line = number,
                                .column = static_cast<std::uint32_t>(first + 1),
                                .length = static_cast<std::uint32_t>(name.size()),
                                .line_text = std::string(whole)}});
    }
  }
  return found;
}

}  // namespace ros2wasm
