// See file_pattern.hpp.
#include "bundler/launch/file_pattern.hpp"

#include <algorithm>
#include <optional>

namespace ros2wasm {
namespace {

constexpr std::size_t kMostPaths = 1000;

/// How many bytes of the pattern stand for this character; nothing when they do not.
std::optional<std::size_t> fits(std::string_view pattern, char c) {
  if (pattern.empty()) return std::nullopt;
  if (pattern[0] == '?') return 1;
  const std::size_t close = pattern[0] == '['
                                ? pattern.find(']', 2 + (pattern.substr(1, 1) == "!" ? 1 : 0))
                                : std::string_view::npos;
  if (close == std::string_view::npos)
    return pattern[0] == c ? std::optional<std::size_t>(1) : std::nullopt;
  const bool inverted = pattern[1] == '!';
  const std::string_view letters = pattern.substr(inverted ? 2 : 1, close - (inverted ? 2 : 1));
  bool found = false;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    const bool range = i + 2 < letters.size() && letters[i + 1] == '-';
    found = found || (range ? letters[i] <= c && c <= letters[i + 2] : letters[i] == c);
    if (range) i += 2;
  }
  return found != inverted ? std::optional(close + 1) : std::nullopt;
}

/// Matches one name. A later `*` never needs the characters of an earlier one, so only the last one
/// is tried again.
bool matches(std::string_view pattern, std::string_view name) {
  if (name.starts_with('.') && !pattern.starts_with('.')) return false;
  std::size_t p = 0;
  std::size_t n = 0;
  std::optional<std::size_t> star;
  std::size_t star_name = 0;
  while (n < name.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_name = n;
    } else if (const auto size = fits(pattern.substr(std::min(p, pattern.size())), name[n])) {
      p += *size;
      ++n;
    } else if (star) {
      p = *star + 1;
      n = ++star_name;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace

bool is_file_pattern(std::string_view path) {
  return path.find_first_of("*?[") != std::string_view::npos;
}

std::vector<std::string> matching_paths(const std::string& path, const LaunchWorld& world) {
  std::vector<std::string> found{""};
  for (std::size_t begin = 1; begin <= path.size();) {
    const std::size_t end = std::min(path.find('/', begin), path.size());
    const std::string part = path.substr(begin, end - begin);
    std::vector<std::string> longer;
    for (const std::string& folder : found) {
      if (!is_file_pattern(part)) {
        longer.push_back(folder + "/" + part);
        continue;
      }
      if (!world.names_in) continue;
      for (const std::string& name : world.names_in(folder))
        if (matches(part, name) && longer.size() < kMostPaths)
          longer.push_back(folder + "/" + name);
    }
    found = std::move(longer);
    begin = end + 1;
  }
  std::erase_if(found, [&](const std::string& one) { return !world.read(one); });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ros2wasm
