// Writes ZIP archives of stored (not compressed) members whose bytes depend on the members only. No
// ZIP64: members and archive stay under 4 GiB.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ros2wasm {

class ZipWriter {
 public:
  void member(std::string_view name, std::string_view bytes, bool executable = false);
  /// Writes the central directory and returns the archive; nothing may be added afterwards.
  [[nodiscard]] std::string finish();

 private:
  std::string bytes_;
  std::string directory_;
  std::uint16_t count_ = 0;
};

/// CRC-32 as ZIP and gzip use it.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes);

}  // namespace ros2wasm
