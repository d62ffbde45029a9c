// See base64.hpp.
#include "bundler/io/base64.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace ros2wasm {
namespace {

constexpr std::string_view kLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::uint8_t kNone = 64;

constexpr std::array<std::uint8_t, 256> value_table() {
  std::array<std::uint8_t, 256> table{};
  table.fill(kNone);
  for (std::size_t i = 0; i < kLetters.size(); ++i)
    table[static_cast<unsigned char>(kLetters[i])] = static_cast<std::uint8_t>(i);
  return table;
}

}  // namespace

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t value = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    for (std::size_t i = 0; i < 3; ++i)
      value = value << 8U | (i < count ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += i > count ? '=' : kLetters[value >> (18U - 6U * i) & 63U];
  }
  return text;
}

std::optional<std::string> base64_read(std::string_view text) {
  static constexpr auto kValues = value_table();
  if (text.size() % 4 != 0) return std::nullopt;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t at = 0; at < text.size(); at += 4) {
    const bool last = at + 4 == text.size();
    const std::size_t padding = !last                            ? 0
                                : text.substr(at + 2, 2) == "==" ? 2
                                : text[at + 3] == '='            ? 1
                                                                 : 0;
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint8_t part = kValues[static_cast<unsigned char>(text[at + i])];
      if (part == kNone && i < 4 - padding) return std::nullopt;
      value = value << 6U | (part == kNone ? 0U : part);
    }
    if ((value & ((1U << (8U * padding)) - 1U)) != 0) return std::nullopt;
    for (std::size_t i = 0; i < 3 - padding; ++i)
      bytes += static_cast<char>(value >> (16U - 8U * i) & 0xFFU);
  }
  return bytes;
}

}  // namespace ros2wasm
