// Walks over the bytes of a WebAssembly module. Pure; hostile input is safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ros2wasm {

/// Any step beyond `end` makes it fail for good. `position <= end <= bytes.size()`.
class WasmCursor {
 public:
  WasmCursor(std::string_view bytes, std::size_t position, std::size_t end)
      : bytes_(bytes), position_(position), end_(end) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool at_end() const { return !ok_ || position_ == end_; }
  [[nodiscard]] std::size_t position() const { return position_; }

  std::uint8_t byte() {
    if (!ok_ || position_ >= end_) {
      ok_ = false;
      return 0;
    }
    return static_cast<std::uint8_t>(bytes_[position_++]);
  }

  std::uint64_t leb() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint8_t next = byte();
      value |= static_cast<std::uint64_t>(next & 0x7FU) << shift;
      if ((next & 0x80U) == 0) return value;
    }
    ok_ = false;
    return 0;
  }

  std::string_view take(std::uint64_t count) {
    if (!ok_ || count > end_ - position_) {
      ok_ = false;
      return {};
    }
    const auto result = bytes_.substr(position_, static_cast<std::size_t>(count));
    position_ += static_cast<std::size_t>(count);
    return result;
  }

  std::string text() { return std::string(take(leb())); }

 private:
  std::string_view bytes_;
  std::size_t position_;
  std::size_t end_;
  bool ok_ = true;
};

}  // namespace ros2wasm
