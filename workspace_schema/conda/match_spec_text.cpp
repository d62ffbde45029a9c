// See match_spec_text.hpp.
#include "workspace_schema/conda/match_spec_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

constexpr auto kSubdirs = std::to_array<std::string_view>(
    {"emscripten-32", "emscripten-wasm32", "freebsd-64",   "linux-32",    "linux-64",
     "linux-aarch64", "linux-armv6l",      "linux-armv7l", "linux-ppc64", "linux-ppc64le",
     "linux-riscv32", "linux-riscv64",     "linux-s390x",  "noarch",      "osx-64",
     "osx-arm64",     "wasi-wasm32",       "win-32",       "win-64",      "win-arm64",
     "zos-z"});

bool one_of(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

bool is_key_char(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-';
}

/// The pair whose value begins behind `equals`, and where the text goes on; nothing when it is
/// none.
std::optional<std::pair<BracketPair, std::size_t>> pair_at(std::string_view text,
                                                           std::size_t equals) {
  std::size_t key_start = equals;
  while (key_start > 0 && is_key_char(text[key_start - 1])) --key_start;
  if (key_start == equals) return std::nullopt;
  const std::string key(text.substr(key_start, equals - key_start));
  std::size_t start = equals + 1;
  if (start < text.size() && one_of(text[start], "'\"")) {
    const std::size_t end = text.find_first_of("'\"", start + 1);
    if (end == std::string_view::npos || text[end] != text[start]) return std::nullopt;
    if (end + 1 < text.size() && !one_of(text[end + 1], ", ")) return std::nullopt;
    return {{{key, std::string(text.substr(start + 1, end - start - 1))},
             std::min(end + 2, text.size())}};
  }
  const std::size_t end = std::min(text.find_first_of(", ", start), text.size());
  const std::string_view value = text.substr(start, end - start);
  if (value.find_first_of("'\"") != std::string_view::npos) return std::nullopt;
  return {{{key, std::string(value)}, std::min(end + 1, text.size())}};
}

}  // namespace

bool known_subdir(std::string_view text) {
  return std::find(kSubdirs.begin(), kSubdirs.end(), text) != kSubdirs.end();
}

std::optional<std::string> take_section(std::string& text, char open, char close) {
  const std::size_t end = text.rfind(close);
  if (end == std::string::npos || end == 0) return std::nullopt;
  const std::size_t start = text.rfind(open, end - 1);
  if (start == std::string::npos) return std::nullopt;
  const std::string section = text.substr(start, end - start + 1);
  std::string rest;
  std::size_t from = 0;
  for (std::size_t at = text.find(section); at != std::string::npos;
       at = text.find(section, from)) {
    rest.append(text, from, at - from);
    from = at + section.size();
  }
  rest.append(text, from);
  text = std::move(rest);
  return section.substr(1, section.size() - 2);
}

std::vector<BracketPair> bracket_pairs(std::string_view text) {
  std::vector<BracketPair> pairs;
  std::size_t start = 0;
  for (std::size_t at = text.find('='); at != std::string_view::npos; at = text.find('=', at)) {
    const auto found = pair_at(text.substr(start), at - start);
    if (found) {
      pairs.push_back(found->first);
      start += found->second;
      at = start;
    } else {
      ++at;
    }
  }
  return pairs;
}

std::string normal_version(const std::string& version, bool has_build) {
  if (version == "==" || version == "=" || !version.starts_with('=')) return version;
  const std::size_t solid = version.find_first_not_of('=');
  std::string rest = solid == std::string::npos ? std::string() : version.substr(solid);
  if (version.starts_with("==") && !has_build) return rest;
  if (rest.find_first_of("=,|") != std::string::npos) return version;
  if (has_build || rest.ends_with('*')) return rest;
  const bool plain =
      rest.find_first_of("*<>!~") == std::string::npos && !rest.empty() && !rest.ends_with('.');
  return rest + (plain ? ".*" : "*");
}

std::string with_single_spaces(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const bool idle =
        c == ' ' && out.size() > 1 && out.back() == ' ' && one_of(out[out.size() - 2], "<>=!~,|");
    if (!idle) out += c;
  }
  return out;
}

std::optional<std::string> whole_number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  std::string digits;
  char last = '_';
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      digits += c;
    } else if (c != '_' || last == '_') {
      return std::nullopt;
    }
    last = c;
  }
  if (last == '_' || (negative && digits.find_first_not_of('0') != std::string::npos))
    return std::nullopt;
  return digits;
}

VersionAndBuild part_version_and_build(std::string_view text) {
  const std::size_t last_sign = text.find_last_of("-=,|<>~");  // none of these is in a build string
  VersionAndBuild parts{.version = std::string(text), .build = std::nullopt};
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    const bool parting = (text[i] == ' ' || text[i] == '=') && !one_of(text[i - 1], "=!|,<>~");
    if (!parting || (last_sign != std::string_view::npos && last_sign > i)) continue;
    parts.version = std::string(text.substr(0, i));
    parts.build = std::string(trimmed(text.substr(i + 1)));
    break;
  }
  std::erase(parts.version, ' ');
  return parts;
}

bool is_package_name(std::string_view name) {
  const auto solid = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  const bool virtual_package = name.starts_with("__");
  const std::size_t first = virtual_package ? 2 : 0;
  if (first >= name.size() || !(solid(name[first]) || (first == 0 && name[0] == '_'))) return false;
  bool separated = false;
  for (const char c : name.substr(first + 1)) {
    const bool separator = one_of(c, "._-");
    if (!solid(c) && (!separator || separated)) return false;
    separated = separator;
  }
  return true;
}

std::string_view last_part(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

bool is_archive_name(std::string_view text) {
  return text.ends_with(".conda") || text.ends_with(".tar.bz2");
}

}  // namespace ros2wasm
