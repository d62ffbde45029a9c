// See page_origin.hpp.
#include "workspace_schema/schema/page_origin.hpp"

#include <algorithm>
#include <string>

namespace ros2wasm {
namespace {

constexpr std::string_view kRule =
    "the origin of a page is `https://` or `http://`, a host in small letters, and a port where it "
    "is not the usual one, such as `https://course.example.org`; \"*\" is every page";
constexpr std::size_t kLongestHost = 253;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_host(char c) {
  return (c >= 'a' && c <= 'z') || is_digit(c) || c == '-' || c == '.';
}

NameFault fault(std::string why, std::size_t offset, std::size_t length) {
  return {.why = std::move(why), .offset = offset, .length = length, .rule = std::string(kRule)};
}

}  // namespace

std::optional<NameFault> page_origin_fault(std::string_view text) {
  if (text == "*") return std::nullopt;
  const bool secure = text.starts_with("https://");
  if (!secure && !text.starts_with("http://"))
    return fault("it does not begin with `https://` or `http://`", 0, std::min(text.size(), 1UL));
  const std::size_t begin = secure ? 8 : 7;
  std::size_t end = begin;
  while (end < text.size() && is_host(text[end])) ++end;
  if (end == begin) return fault("it has no host", begin, end < text.size() ? 1 : 0);
  if (end - begin > kLongestHost) return fault("its host is too long", begin, end - begin);
  if (end == text.size()) return std::nullopt;
  if (text[end] == '/') {
    NameFault path = fault("an origin has no path", end, text.size() - end);
    path.better = std::string(text.substr(0, end));
    return path;
  }
  const std::string_view port = text.substr(std::min(end + 1, text.size()));
  if (text[end] != ':') return fault("this does not belong into a host", end, 1);
  const bool number = !port.empty() && port.size() <= 5 && port.front() != '0' &&
                      std::all_of(port.begin(), port.end(), is_digit);
  if (!number) return fault("its port is not a number", end, text.size() - end);
  if (port == (secure ? "443" : "80")) {
    NameFault usual = fault("browsers leave the usual port out", end, text.size() - end);
    usual.better = std::string(text.substr(0, end));
    return usual;
  }
  return std::nullopt;
}

}  // namespace ros2wasm
