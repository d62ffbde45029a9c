// See secret_text.hpp.
#include "workspace_schema/base/secret_text.hpp"

#include <algorithm>
#include <cctype>

namespace ros2wasm {
namespace {

/// Half-open ranges in an address; empty when there is no such part.
struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] bool empty() const { return begin == end; }
};

struct Parts {
  Range user_info;  ///< without the @
  Range token;      ///< without /t/ before it
  std::size_t end = 0;
};

bool ends_address(char c) {
  return static_cast<unsigned char>(c) <= ' ' || c == '"' || c == '\'' || c == '`' || c == '<' ||
         c == '>';
}

/// A path of this machine has no token: `/t/` there is a folder.
bool is_file(std::string_view text, std::size_t after_scheme) {
  std::size_t begin = after_scheme - 3;
  while (begin > 0 && std::isalnum(static_cast<unsigned char>(text[begin - 1])) != 0) --begin;
  std::string scheme(text.substr(begin, after_scheme - 3 - begin));
  for (char& c : scheme) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return scheme == "file";
}

/// `after_scheme`: behind the `://`.
Parts parts_of(std::string_view text, std::size_t after_scheme) {
  Parts parts;
  parts.end = after_scheme;
  while (parts.end < text.size() && !ends_address(text[parts.end])) ++parts.end;
  const std::string_view address = text.substr(0, parts.end);
  const std::size_t host_end = std::min(address.find_first_of("/?#", after_scheme), parts.end);
  const std::size_t at = address.substr(0, host_end).rfind('@');
  if (at != std::string_view::npos && at >= after_scheme) parts.user_info = {after_scheme, at};
  if (is_file(text, after_scheme)) return parts;
  const std::size_t mark = address.find("/t/", host_end);
  if (mark == std::string_view::npos) return parts;
  const std::size_t begin = mark + 3;
  parts.token = {begin, std::min(address.find_first_of("/?#", begin), parts.end)};
  return parts;
}

}  // namespace

std::string with_masked_secrets(std::string_view text) {
  std::string out(text);
  for (std::size_t colon = text.find("://"); colon != std::string_view::npos;
       colon = text.find("://", colon + 3)) {
    const Parts parts = parts_of(text, colon + 3);
    for (const Range range : {parts.user_info, parts.token}) {
      std::fill(out.begin() + static_cast<std::ptrdiff_t>(range.begin),
                out.begin() + static_cast<std::ptrdiff_t>(range.end), '*');
    }
  }
  return out;
}

AddressSecrets secrets_of(std::string_view url) {
  const std::size_t colon = url.find("://");
  if (colon == std::string_view::npos) return {};
  const Parts parts = parts_of(url, colon + 3);
  const auto text = [url](Range range) {
    return std::string(url.substr(range.begin, range.end - range.begin));
  };
  return {.user_info = text(parts.user_info), .token = text(parts.token)};
}

std::string without_secrets(std::string_view url) {
  const std::size_t colon = url.find("://");
  if (colon == std::string_view::npos) return std::string(url);
  const Parts parts = parts_of(url, colon + 3);
  std::string out(url);
  if (!parts.token.empty()) {  // from the back, so that the other range stays right
    out.erase(parts.token.begin - 2, parts.token.end - parts.token.begin + 2);
    if (out.size() > parts.token.begin - 2 && out[parts.token.begin - 2] == '/')
      out.erase(parts.token.begin - 2, 1);
    while (out.ends_with('/') && !url.ends_with('/')) out.pop_back();
  }
  if (!parts.user_info.empty()) {
    out.erase(parts.user_info.begin, parts.user_info.end - parts.user_info.begin + 1);
  }
  return out;
}

}  // namespace ros2wasm
