// Numbers and texts of MCAP files: little-endian, texts and lists behind their length in 32 bits.
// The files may come from anywhere, so every length is checked before it is used.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace rosbag2_storage::mcap {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "numbers are copied as they lie");

/// The content of a file is not possible.
class Damaged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using Texts = std::map<std::string, std::string>;

class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  [[nodiscard]] bool at_end() const { return rest_.empty(); }

  std::string_view take(uint64_t size) {
    if (size > rest_.size()) {
      throw Damaged("a record is shorter than it says");
    }
    const std::string_view taken = rest_.substr(0, static_cast<size_t>(size));
    rest_.remove_prefix(taken.size());
    return taken;
  }
  template <typename T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::string_view text() { return take(number<uint32_t>()); }
  std::string string() { return std::string(text()); }
  /// A list: its length in bytes is before all its items.
  ByteReader list() { return ByteReader(text()); }
  Texts texts() {
    Texts found;
    for (ByteReader all = list(); !all.at_end();) {
      std::string key = all.string();
      found.insert_or_assign(std::move(key), all.string());
    }
    return found;
  }

 private:
  std::string_view rest_;
};

class ByteWriter {
 public:
  template <typename T>
  ByteWriter& number(T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
    return *this;
  }
  ByteWriter& text(std::string_view value) {
    number(static_cast<uint32_t>(value.size()));
    bytes.append(value);
    return *this;
  }
  ByteWriter& texts(const Texts& values) {
    ByteWriter all;
    for (const auto& [key, value] : values) {
      all.text(key).text(value);
    }
    return text(all.bytes);
  }

  std::string bytes;
};

}  // namespace rosbag2_storage::mcap
