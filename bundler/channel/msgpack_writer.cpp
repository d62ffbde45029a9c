// See msgpack_writer.hpp. Every value takes its shortest form, so that one content has one form.
#include "bundler/channel/msgpack_writer.hpp"

namespace ros2wasm {

void MsgpackWriter::put(std::uint64_t value, int byte_count) {
  for (int shift = 8 * (byte_count - 1); shift >= 0; shift -= 8)
    data_ += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xffU);
}

MsgpackWriter& MsgpackWriter::head(std::size_t count, unsigned small, std::size_t small_end,
                                   unsigned medium, unsigned large) {
  if (count < small_end) {
    put(small | count, 1);
  } else if (count <= 0xffff) {
    put(medium, 1);
    put(count, 2);
  } else {
    put(large, 1);
    put(count, 4);
  }
  return *this;
}

MsgpackWriter& MsgpackWriter::text(std::string_view value) {
  if (value.size() >= 32 && value.size() <= 0xff) {
    put(0xd9, 1);
    put(value.size(), 1);
  } else {
    head(value.size(), 0xa0, 32, 0xda, 0xdb);
  }
  data_ += value;
  return *this;
}

MsgpackWriter& MsgpackWriter::bytes(std::string_view value) {
  if (value.size() <= 0xff) {
    put(0xc4, 1);
    put(value.size(), 1);
  } else {
    head(value.size(), 0, 0, 0xc5, 0xc6);
  }
  data_ += value;
  return *this;
}

MsgpackWriter& MsgpackWriter::number(std::uint64_t value) {
  if (value < 0x80) {
    put(value, 1);
  } else if (value <= 0xff) {
    put(0xcc, 1);
    put(value, 1);
  } else if (value <= 0xffff) {
    put(0xcd, 1);
    put(value, 2);
  } else if (value <= 0xffff'ffff) {
    put(0xce, 1);
    put(value, 4);
  } else {
    put(0xcf, 1);
    put(value, 8);
  }
  return *this;
}

}  // namespace ros2wasm
