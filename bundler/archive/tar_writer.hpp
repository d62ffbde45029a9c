// Writes tar archives whose bytes depend on the members only: POSIX ustar, with a pax header where
// a name is long or not ASCII. Owner 0, time 0, modes 644 and 755.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

class TarWriter {
 public:
  void file(std::string_view path, std::string_view bytes, bool executable = false);
  void link(std::string_view path, std::string_view target);
  void directory(std::string_view path);
  /// Ends the archive and returns its bytes; nothing may be added afterwards.
  [[nodiscard]] std::string finish();

 private:
  void header(std::string_view path, std::string_view target, char type, std::size_t size,
              unsigned mode);
  void block(std::string_view path, std::string_view target, char type, std::size_t size,
             unsigned mode);
  void pad();

  std::string bytes_;
};

}  // namespace ros2wasm
