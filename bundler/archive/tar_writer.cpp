// See tar_writer.hpp.
#include "bundler/archive/tar_writer.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <numeric>

namespace ros2wasm {
namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kNameRoom = 100;

void put_octal(char* field, std::size_t digits, std::size_t value) {
  for (std::size_t i = digits; i-- > 0; value >>= 3U)
    field[i] = static_cast<char>('0' + (value & 7U));
}

bool fits(std::string_view text) {
  return text.size() <= kNameRoom && std::all_of(text.begin(), text.end(), [](char c) {
           return static_cast<unsigned char>(c) < 0x80;
         });
}

/// "<length> key=value\n", where the length counts itself.
std::string pax_record(std::string_view key, std::string_view value) {
  const std::size_t rest = key.size() + value.size() + 3;
  std::size_t length = rest + 1;
  while (length != rest + std::to_string(length).size())
    length = rest + std::to_string(length).size();
  std::string record = std::to_string(length);
  record.append(" ").append(key).append("=").append(value).append("\n");
  return record;
}

}  // namespace

void TarWriter::file(std::string_view path, std::string_view bytes, bool executable) {
  header(path, {}, '0', bytes.size(), executable ? 0755 : 0644);
  bytes_.append(bytes);
  pad();
}

void TarWriter::link(std::string_view path, std::string_view target) {
  header(path, target, '2', 0, 0777);
}

void TarWriter::directory(std::string_view path) {
  header(std::string(path) + "/", {}, '5', 0, 0755);
}

std::string TarWriter::finish() {
  bytes_.append(2 * kBlock, '\0');
  return std::move(bytes_);
}

void TarWriter::header(std::string_view path, std::string_view target, char type, std::size_t size,
                       unsigned mode) {
  std::string extra;
  if (!fits(path)) extra += pax_record("path", path);
  if (!fits(target)) extra += pax_record("linkpath", target);
  if (size > 077777777777ULL) extra += pax_record("size", std::to_string(size));
  if (!extra.empty()) {
    block("pax_header", {}, 'x', extra.size(), 0644);
    bytes_ += extra;
    pad();
  }
  block(fits(path) ? path : "long_name", fits(target) ? target : "long_target", type, size, mode);
}

void TarWriter::block(std::string_view path, std::string_view target, char type, std::size_t size,
                      unsigned mode) {
  std::array<char, kBlock> head{};
  std::memcpy(head.data(), path.data(), path.size());
  put_octal(head.data() + 100, 7, mode);
  put_octal(head.data() + 108, 7, 0);  // owner
  put_octal(head.data() + 116, 7, 0);  // group
  put_octal(head.data() + 124, 11, size);
  put_octal(head.data() + 136, 11, 0);  // time
  head[156] = type;
  std::memcpy(head.data() + 157, target.data(), target.size());
  std::memcpy(head.data() + 257, "ustar\00000", 8);
  std::fill_n(head.data() + 148, 8, ' ');
  const auto sum = std::accumulate(
      head.begin(), head.end(), std::size_t{0},
      [](std::size_t total, char c) { return total + static_cast<unsigned char>(c); });
  put_octal(head.data() + 148, 6, sum);
  head[154] = '\0';
  bytes_.append(head.data(), head.size());
}

void TarWriter::pad() {
  bytes_.append((kBlock - bytes_.size() % kBlock) % kBlock, '\0');
}

}  // namespace ros2wasm
