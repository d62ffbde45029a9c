// See wasm_object.hpp.
#include "bundler/build/wasm_object.hpp"

#include <algorithm>
#include <charconv>

#include "bundler/archive/wasm_cursor.hpp"
#include "bundler/archive/wasm_module.hpp"

namespace ros2wasm {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kArchive = "!<arch>\n";
constexpr std::size_t kMemberHeader = 60;
constexpr std::size_t kSizeAt = 48;  // in a member's header, ten digits
constexpr std::size_t kSizeDigits = 10;
constexpr std::string_view kHeaderEnd = "`\n";

/// An object with nothing in it; no compiler writes such a one.
constexpr std::string_view kSharedMark = "\0asm\1\0\0\0\0\x09\x07linking\x02"sv;

constexpr std::uint64_t kLinkingVersion = 2;
constexpr std::uint8_t kSymbolTable = 8;
constexpr std::uint64_t kWeak = 0x01;
constexpr std::uint64_t kBinding = 0x03;  // weak or local; neither is strong
constexpr std::uint64_t kHidden = 0x04;
constexpr std::uint64_t kUndefined = 0x10;
constexpr std::uint64_t kNamed = 0x40;

enum SymbolKind : std::uint8_t { kFunction, kData, kGlobal, kSection, kTag, kTable };

struct Member {
  std::size_t begin = 0;
  std::string_view bytes;
};

std::optional<std::vector<Member>> members_of(std::string_view archive) {
  if (!archive.starts_with(kArchive)) return std::nullopt;
  std::vector<Member> result;
  std::size_t at = kArchive.size();
  while (at < archive.size()) {
    const std::string_view header = archive.substr(at, kMemberHeader);
    if (header.size() < kMemberHeader || !header.ends_with(kHeaderEnd)) return std::nullopt;
    const std::string_view digits = header.substr(kSizeAt, kSizeDigits);
    std::size_t size = 0;
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), size);
    at += kMemberHeader;
    if (read.ec != std::errc() || size > archive.size() - at) return std::nullopt;
    result.push_back({.begin = at, .bytes = archive.substr(at, size)});
    at += size + size % 2;  // they begin at even places
  }
  return result;
}

/// The symbols of one symbol table; false when it is damaged.
bool read_symbols(WasmCursor& cursor, std::vector<ObjectSymbol>& result) {
  for (std::uint64_t left = cursor.leb(); left > 0 && cursor.ok(); --left) {
    const std::uint8_t kind = cursor.byte();
    ObjectSymbol symbol{.name = {}, .flags = cursor.position()};
    const std::uint64_t flags = cursor.leb();
    symbol.is_hidden = (flags & kHidden) != 0;
    const bool is_defined = (flags & kUndefined) == 0;
    if (kind == kData) {
      symbol.name = cursor.text();
      if (is_defined)
        for (int field = 0; field < 3; ++field) cursor.leb();  // segment, offset, size
    } else if (kind == kSection) {
      cursor.leb();
      continue;  // names nothing that others see
    } else if (kind <= kTable) {
      cursor.leb();  // index
      if (is_defined || (flags & kNamed) != 0) symbol.name = cursor.text();
    } else {
      return false;
    }
    if (is_defined && (flags & kBinding) == 0) result.push_back(std::move(symbol));
  }
  return cursor.ok();
}

}  // namespace

std::optional<std::vector<ObjectSymbol>> strong_definitions(std::string_view object) {
  const auto module = read_wasm_module(object);
  if (!module) return std::nullopt;
  std::vector<ObjectSymbol> result;
  for (const WasmSection& section : module->sections) {
    if (section.name != "linking") continue;
    WasmCursor cursor(object, section.contents, section.end);
    if (cursor.leb() != kLinkingVersion) return std::nullopt;
    while (!cursor.at_end()) {
      const std::uint8_t kind = cursor.byte();
      const std::uint64_t size = cursor.leb();
      const std::size_t begin = cursor.position();
      cursor.take(size);
      if (!cursor.ok()) return std::nullopt;
      WasmCursor table(object, begin, cursor.position());
      if (kind == kSymbolTable && !read_symbols(table, result)) return std::nullopt;
    }
    if (!cursor.ok()) return std::nullopt;
  }
  return result;
}

std::optional<std::vector<ObjectSymbol>> archive_definitions(std::string_view archive) {
  const auto members = members_of(archive);
  if (!members) return std::nullopt;
  std::vector<ObjectSymbol> result;
  for (const Member& member : *members) {
    auto symbols = strong_definitions(member.bytes);
    if (!symbols) continue;
    for (ObjectSymbol& symbol : *symbols) {
      symbol.flags += member.begin;
      result.push_back(std::move(symbol));
    }
  }
  return result;
}

std::optional<std::vector<std::string_view>> archive_members(std::string_view archive) {
  const auto members = members_of(archive);
  if (!members) return std::nullopt;
  std::vector<std::string_view> result;
  for (const Member& member : *members) result.push_back(member.bytes);
  return result;
}

void make_weak(std::string& bytes, const ObjectSymbol& symbol) {
  // The lowest bits of a LEB128 number stand in its first byte: its length stays.
  bytes.at(symbol.flags) =
      static_cast<char>(static_cast<unsigned char>(bytes[symbol.flags]) | kWeak);
}

bool is_natively_shared(std::string_view archive) {
  const auto members = members_of(archive);
  return members && std::any_of(members->begin(), members->end(),
                                [](const Member& one) { return one.bytes == kSharedMark; });
}

}  // namespace ros2wasm
