// See lz4.hpp. Checksums are passed over: chunks have their own.
#include "lz4.hpp"

#include "bytes.hpp"

namespace rosbag2_storage::mcap {
namespace {

constexpr uint32_t kFrameMagic = 0x184D2204;

/// 15 goes on in the bytes behind it.
uint64_t length_of(unsigned first, ByteReader& from) {
  uint64_t sum = first;
  for (uint8_t more = 255; first == 15 && more == 255; sum += more) {
    more = from.number<uint8_t>();
  }
  return sum;
}

/// Matches may reach back into earlier blocks.
void unpack_block(ByteReader from, std::string& out, size_t size) {
  while (!from.at_end()) {
    const auto token = from.number<uint8_t>();
    const std::string_view literals = from.take(length_of(token >> 4, from));
    if (literals.size() > size - out.size()) {
      throw Damaged("LZ4 data make more than they say");
    }
    out.append(literals);
    // The last part of a block has no match.
    if (from.at_end()) {
      return;
    }
    const size_t back = from.number<uint16_t>();
    const uint64_t match = 4 + length_of(token & 15, from);
    if (back == 0 || back > out.size() || match > size - out.size()) {
      throw Damaged("LZ4 data point outside of what they made");
    }
    // One by one: a match may overlap itself.
    for (uint64_t i = 0; i < match; ++i) {
      out.push_back(out[out.size() - back]);
    }
  }
}

}  // namespace

std::string unpack_lz4(std::string_view frames, size_t size) {
  constexpr size_t kMostGrowth = 255;
  if (size / kMostGrowth > frames.size()) {
    throw Damaged("LZ4 data are too short for what they say");
  }
  std::string out;
  out.reserve(size);
  for (ByteReader from(frames); !from.at_end();) {
    if (from.number<uint32_t>() != kFrameMagic) {
      throw Damaged("a chunk is not a frame of LZ4");
    }
    const auto flags = from.number<uint8_t>();
    if (flags >> 6 != 1 || (flags & 1) != 0) {
      throw Damaged("an LZ4 of another version, or with a dictionary");
    }
    // Size of blocks, size of the content, checksum of the head.
    from.take(2 + ((flags & 8) != 0 ? 8 : 0));
    while (const auto head = from.number<uint32_t>()) {
      const std::string_view block = from.take(head & 0x7FFFFFFF);
      if (head >> 31 == 0) {
        unpack_block(ByteReader(block), out, size);
      } else if (block.size() <= size - out.size()) {
        out.append(block);
      } else {
        throw Damaged("LZ4 data make more than they say");
      }
      from.take((flags & 16) != 0 ? 4 : 0);
    }
    from.take((flags & 4) != 0 ? 4 : 0);
  }
  if (out.size() != size) {
    throw Damaged("a chunk has other bytes than it says");
  }
  return out;
}

}  // namespace rosbag2_storage::mcap
