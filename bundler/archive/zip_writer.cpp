// See zip_writer.hpp.
#include "bundler/archive/zip_writer.hpp"

#include <array>

namespace ros2wasm {
namespace {

constexpr std::uint16_t kVersionNeeded = 20;
constexpr std::uint16_t kUtf8Names = 1U << 11U;
constexpr std::uint16_t kFirstDay = (1U << 5U) | 1U;  // 1980-01-01, the earliest that ZIP can say

void put16(std::string& out, std::uint32_t value) {
  out += static_cast<char>(value & 0xFFU);
  out += static_cast<char>((value >> 8U) & 0xFFU);
}

void put32(std::string& out, std::uint32_t value) {
  put16(out, value & 0xFFFFU);
  put16(out, value >> 16U);
}

constexpr std::array<std::uint32_t, 256> crc_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    std::uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit)
      value = (value >> 1U) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
    table[i] = value;
  }
  return table;
}

/// The fields that the local header and the central directory have in common.
std::string member_facts(std::string_view name, std::string_view bytes) {
  std::string facts;
  put16(facts, kVersionNeeded);
  put16(facts, kUtf8Names);
  put16(facts, 0);  // stored
  put16(facts, 0);  // midnight
  put16(facts, kFirstDay);
  put32(facts, crc32(bytes));
  put32(facts, static_cast<std::uint32_t>(bytes.size()));
  put32(facts, static_cast<std::uint32_t>(bytes.size()));
  put16(facts, static_cast<std::uint32_t>(name.size()));
  put16(facts, 0);  // no extra fields
  return facts;
}

}  // namespace

std::uint32_t crc32(std::string_view bytes) {
  static constexpr auto kTable = crc_table();
  std::uint32_t value = 0xFFFFFFFFU;
  for (const char c : bytes)
    value = kTable[(value ^ static_cast<unsigned char>(c)) & 0xFFU] ^ (value >> 8U);
  return value ^ 0xFFFFFFFFU;
}

void ZipWriter::member(std::string_view name, std::string_view bytes, bool executable) {
  const std::string facts = member_facts(name, bytes);
  const auto offset = static_cast<std::uint32_t>(bytes_.size());
  put32(bytes_, 0x04034b50U);
  bytes_.append(facts).append(name).append(bytes);
  put32(directory_, 0x02014b50U);
  put16(directory_, (3U << 8U) | kVersionNeeded);  // made on Unix
  directory_ += facts;
  put16(directory_, 0);                                          // no comment
  put16(directory_, 0);                                          // disk
  put16(directory_, 0);                                          // internal attributes
  put32(directory_, (executable ? 0100755U : 0100644U) << 16U);  // regular file
  put32(directory_, offset);
  directory_ += name;
  ++count_;
}

std::string ZipWriter::finish() {
  const auto directory_at = static_cast<std::uint32_t>(bytes_.size());
  bytes_ += directory_;
  put32(bytes_, 0x06054b50U);
  put16(bytes_, 0);
  put16(bytes_, 0);
  put16(bytes_, count_);
  put16(bytes_, count_);
  put32(bytes_, static_cast<std::uint32_t>(directory_.size()));
  put32(bytes_, directory_at);
  put16(bytes_, 0);
  return std::move(bytes_);
}

}  // namespace ros2wasm
