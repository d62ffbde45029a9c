// Writes MessagePack, as far as a channel's shards need it. Pure. The caller keeps its promises
// about how many items follow.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace ros2wasm {

class MsgpackWriter {
 public:
  MsgpackWriter& map(std::size_t pairs) { return head(pairs, 0x80, 16, 0xde, 0xdf); }
  MsgpackWriter& array(std::size_t items) { return head(items, 0x90, 16, 0xdc, 0xdd); }
  MsgpackWriter& text(std::string_view value);
  MsgpackWriter& bytes(std::string_view value);
  MsgpackWriter& number(std::uint64_t value);

  [[nodiscard]] const std::string& data() const { return data_; }

 private:
  MsgpackWriter& head(std::size_t count, unsigned small, std::size_t small_end, unsigned medium,
                      unsigned large);
  void put(std::uint64_t value, int byte_count);

  std::string data_;
};

}  // namespace ros2wasm
