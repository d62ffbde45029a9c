// See msgpack_reader.hpp.
#include "bundler/channel/msgpack_reader.hpp"

#include <algorithm>
#include <bit>
#include <string>

#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {
namespace {

constexpr int kDeepest = 200;
constexpr std::uint32_t kMostMade = 1'000'000;  ///< a byte of the text makes 40 of a value
constexpr std::uint64_t kMostExpected = 64;     ///< items; the bytes may promise any number

/// A number of `size_bytes` bytes with its sign in all 64 bits.
std::uint64_t sign_extended(std::uint64_t bits, unsigned size_bytes) {
  const unsigned unused = 64 - 8 * size_bytes;
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(bits << unused) >> unused);
}

}  // namespace

struct MsgpackReader::Token {
  Kind kind = Kind::kNull;
  std::uint64_t number = 0;  ///< the bits of a number; how many items or pairs follow
  std::string_view content{};
};

/// Big-endian.
std::optional<std::uint64_t> MsgpackReader::number(unsigned size_bytes) {
  if (rest_.size() < size_bytes) return std::nullopt;
  std::uint64_t value = 0;
  for (unsigned i = 0; i < size_bytes; ++i)
    value = value << 8U | static_cast<unsigned char>(rest_[i]);
  rest_.remove_prefix(size_bytes);
  return value;
}

std::optional<MsgpackReader::Token> MsgpackReader::counted(Kind kind, unsigned size_bytes) {
  const auto count = number(size_bytes);
  return count ? std::optional(Token{kind, *count}) : std::nullopt;
}

std::optional<MsgpackReader::Token> MsgpackReader::sized(Kind kind,
                                                         std::optional<std::uint64_t> size) {
  if (!size || *size > rest_.size()) return std::nullopt;
  const Token taken{kind, 0, rest_.substr(0, *size)};
  rest_.remove_prefix(*size);
  return taken;
}

/// Bytes with a type in front, which says nothing here.
std::optional<MsgpackReader::Token> MsgpackReader::extension(std::optional<std::uint64_t> size) {
  if (rest_.empty()) return std::nullopt;
  rest_.remove_prefix(1);
  return sized(Kind::kBytes, size);
}

/// A value, or the head of an array or map.
std::optional<MsgpackReader::Token> MsgpackReader::token() {
  if (rest_.empty()) return std::nullopt;
  const unsigned head = static_cast<unsigned char>(rest_.front());
  rest_.remove_prefix(1);
  if (head < 0x80) return Token{Kind::kUnsigned, head};
  if (head < 0x90) return Token{Kind::kMap, head & 0x0fU};
  if (head < 0xa0) return Token{Kind::kArray, head & 0x0fU};
  if (head < 0xc0) return sized(Kind::kText, head & 0x1fU);
  if (head >= 0xe0) return Token{Kind::kSigned, sign_extended(head, 1)};
  switch (head) {
    case 0xc0:
      return Token{};
    case 0xc2:
    case 0xc3:
      return Token{Kind::kBool, head & 1U};
    case 0xc4:
    case 0xc5:
    case 0xc6:
      return sized(Kind::kBytes, number(1U << (head - 0xc4U)));
    case 0xc7:
    case 0xc8:
    case 0xc9:
      return extension(number(1U << (head - 0xc7U)));
    case 0xca:
      return counted(Kind::kFloat, 4);
    case 0xcb:
      return counted(Kind::kDouble, 8);
    case 0xcc:
    case 0xcd:
    case 0xce:
    case 0xcf:
      return counted(Kind::kUnsigned, 1U << (head - 0xccU));
    case 0xd0:
    case 0xd1:
    case 0xd2:
    case 0xd3: {
      auto value = counted(Kind::kSigned, 1U << (head - 0xd0U));
      if (value) value->number = sign_extended(value->number, 1U << (head - 0xd0U));
      return value;
    }
    case 0xd4:
    case 0xd5:
    case 0xd6:
    case 0xd7:
    case 0xd8:
      return extension(1U << (head - 0xd4U));
    case 0xd9:
    case 0xda:
    case 0xdb:
      return sized(Kind::kText, number(1U << (head - 0xd9U)));
    case 0xdc:
    case 0xdd:
      return counted(Kind::kArray, 2U << (head - 0xdcU));
    case 0xde:
    case 0xdf:
      return counted(Kind::kMap, 2U << (head - 0xdeU));
    default:
      return std::nullopt;
  }
}

std::optional<std::uint32_t> MsgpackReader::map() {
  const auto next = token();
  if (!next || next->kind != Kind::kMap) return std::nullopt;
  return static_cast<std::uint32_t>(next->number);
}

std::optional<std::uint32_t> MsgpackReader::array() {
  const auto next = token();
  if (!next || next->kind != Kind::kArray) return std::nullopt;
  return static_cast<std::uint32_t>(next->number);
}

/// Most of an index is texts of less than 32 bytes: these are taken without a look at all else that
/// there may be. Empty when something else comes; an empty text does, too.
std::string_view MsgpackReader::short_text() {
  if (rest_.empty()) return {};
  const unsigned head = static_cast<unsigned char>(rest_.front());
  const std::size_t size = head & 0x1fU;
  if ((head & 0xe0U) != 0xa0U || size >= rest_.size()) return {};
  const std::string_view text = rest_.substr(1, size);
  if (size != 0) rest_.remove_prefix(1 + size);
  return text;
}

std::optional<std::string_view> MsgpackReader::key() {
  if (const std::string_view text = short_text(); !text.empty()) return text;
  const auto next = token();
  if (!next || next->kind != Kind::kText) return std::nullopt;
  return next->content;
}

std::optional<std::string_view> MsgpackReader::content() {
  const auto next = token();
  if (!next || (next->kind != Kind::kText && next->kind != Kind::kBytes)) return std::nullopt;
  return next->content;
}

/// Counts the values that are still to come instead of descending into them: no depth is too deep.
std::optional<std::string_view> MsgpackReader::skipped() {
  const std::string_view before = rest_;
  for (std::uint64_t left = 1; left > 0; --left) {
    if (!short_text().empty()) continue;
    const auto next = token();
    if (!next) return std::nullopt;
    if (next->kind == Kind::kArray) left += next->number;
    if (next->kind == Kind::kMap) left += 2 * next->number;
  }
  return before.substr(0, before.size() - rest_.size());
}

std::optional<JsonValue> MsgpackReader::value() {
  JsonValue value;
  if (!read(kDeepest, value)) return std::nullopt;
  return value;
}

/// False when it cannot be read.
bool MsgpackReader::read(int levels, JsonValue& into) {
  const auto next = token();
  if (!next || ++made_ > kMostMade) return false;
  switch (next->kind) {
    case Kind::kNull:
      break;
    case Kind::kBool:
      into.state() = next->number != 0;
      break;
    case Kind::kSigned:
      into.state() = static_cast<std::int64_t>(next->number);
      break;
    case Kind::kUnsigned:
      into.state() = next->number;
      break;
    case Kind::kFloat:
      into.state() = double{std::bit_cast<float>(static_cast<std::uint32_t>(next->number))};
      break;
    case Kind::kDouble:
      into.state() = std::bit_cast<double>(next->number);
      break;
    case Kind::kText:
      into.state() = std::string(next->content);
      break;
    case Kind::kBytes:
      into.state() = hex_text(next->content);
      break;
    case Kind::kArray:
      return levels > 0 &&
             items(next->number, levels - 1, into.state().emplace<JsonValue::Array>());
    case Kind::kMap:
      return levels > 0 &&
             members(next->number, levels - 1, into.state().emplace<JsonValue::Object>());
  }
  return true;
}

bool MsgpackReader::items(std::uint64_t count, int levels, JsonValue::Array& into) {
  into.reserve(std::min<std::uint64_t>(count, kMostExpected));
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!read(levels, into.emplace_back())) return false;
  }
  return true;
}

bool MsgpackReader::members(std::uint64_t count, int levels, JsonValue::Object& into) {
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto name = key();
    if (!name || !read(levels, into.emplace_back(*name, JsonValue()).second)) return false;
  }
  return true;
}

}  // namespace ros2wasm
