// See request_rules.hpp.
#include "bundler/serve/request_rules.hpp"

#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <memory>

#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/base/trimmed_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kBlanks = " \t";

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<std::string> decoded_segment(std::string_view text) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char c = text[i];
    if (c == '%') {
      if (i + 2 >= text.size()) return std::nullopt;
      const int high = hex_digit(text[i + 1]);
      const int low = hex_digit(text[i + 2]);
      if (high < 0 || low < 0) return std::nullopt;
      c = static_cast<char>(high * 16 + low);
      i += 2;
    }
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || c == '/' || c == '\\') return std::nullopt;
    decoded += c;
  }
  if (decoded.empty() || decoded == "." || decoded == "..") return std::nullopt;
  return decoded;
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool is_ipv4(std::string_view text) {
  return std::count(text.begin(), text.end(), '.') == 3 &&
         std::all_of(text.begin(), text.end(),
                     [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
}

}  // namespace

std::optional<std::string> site_path_of(std::string_view target) {
  if (target.empty() || target.front() != '/') return std::nullopt;
  target = target.substr(1, target.find_first_of("?#") - 1);
  std::string path;
  while (!target.empty()) {
    const std::size_t slash = std::min(target.find('/'), target.size());
    const auto segment = decoded_segment(target.substr(0, slash));
    if (!segment) return std::nullopt;
    path += *segment;
    target.remove_prefix(slash);
    if (!target.empty()) {
      path += '/';
      target.remove_prefix(1);
    }
  }
  return path;
}

bool is_local_host(std::string_view host_header) {
  std::string host(trimmed(host_header, kBlanks));
  for (char& c : host) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (host.starts_with('[')) return host.find(']') != std::string::npos;
  if (const std::size_t colon = host.find(':'); colon != std::string::npos) host.resize(colon);
  return host == "localhost" || host.ends_with(".localhost") || is_ipv4(host);
}

bool is_loopback(const std::string& host) {
  if (ascii_lower(host) == "localhost") return true;
  const addrinfo hints{.ai_flags = AI_NUMERICHOST, .ai_family = AF_UNSPEC};
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) return false;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
  if (found->ai_family == AF_INET) {
    sockaddr_in address{};
    std::memcpy(&address, found->ai_addr, sizeof address);
    return (ntohl(address.sin_addr.s_addr) >> 24U) == IN_LOOPBACKNET;
  }
  sockaddr_in6 address{};
  std::memcpy(&address, found->ai_addr, sizeof address);
  return IN6_IS_ADDR_LOOPBACK(&address.sin6_addr) ||
         (IN6_IS_ADDR_V4MAPPED(&address.sin6_addr) &&
          address.sin6_addr.s6_addr[12] == IN_LOOPBACKNET);
}

bool matches_etag(std::string_view if_none_match, std::string_view etag) {
  while (!if_none_match.empty()) {
    const std::size_t comma = std::min(if_none_match.find(','), if_none_match.size());
    std::string_view tag = trimmed(if_none_match.substr(0, comma), kBlanks);
    if (tag.starts_with("W/")) tag.remove_prefix(2);
    if (tag == etag || tag == "*") return true;
    if_none_match.remove_prefix(std::min(comma + 1, if_none_match.size()));
  }
  return false;
}

RangeResult range_of(std::string_view header, std::uint64_t size) {
  constexpr std::string_view kUnit = "bytes=";
  header = trimmed(header, kBlanks);
  if (!header.starts_with(kUnit)) return {};
  header.remove_prefix(kUnit.size());
  const std::size_t dash = header.find('-');
  if (dash == std::string_view::npos || header.find(',') != std::string_view::npos) return {};
  const std::string_view first_text = trimmed(header.substr(0, dash), kBlanks);
  const std::string_view last_text = trimmed(header.substr(dash + 1), kBlanks);
  const auto first = whole_number(first_text);
  const auto last = whole_number(last_text);
  if ((!first && !first_text.empty()) || (!last && !last_text.empty())) return {};
  if (!first && !last) return {};
  if (!first) {
    if (*last == 0 || size == 0) return {.answer = RangeAnswer::kUnsatisfiable, .range = {}};
    const std::uint64_t length = std::min(*last, size);
    return {.answer = RangeAnswer::kPart, .range = {.first = size - length, .length = length}};
  }
  if (last && *last < *first) return {};
  if (*first >= size) return {.answer = RangeAnswer::kUnsatisfiable, .range = {}};
  const std::uint64_t end = last ? std::min(*last, size - 1) : size - 1;
  return {.answer = RangeAnswer::kPart, .range = {.first = *first, .length = end - *first + 1}};
}

}  // namespace ros2wasm
