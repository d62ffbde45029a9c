// CDR (XCDR1, plain) primitives: sizes, a checked writer, a checked reader. Header only.
// Alignment counts from the byte after the 4-byte header and is at most 8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace ros2wasm_typesupport {

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "the fast paths copy little-endian values as they lie");

/// Bytes in front of the payload: encapsulation kind (2) and options (2).
inline constexpr size_t kCdrHeaderSize = 4;

/// Padding that brings `position` to a multiple of `alignment` (1, 2, 4 or 8).
constexpr size_t cdr_padding(size_t position, size_t alignment) {
  return (alignment - (position & (alignment - 1))) & (alignment - 1);
}

/// Adds up what a writer would write.
class CdrSizer {
 public:
  void add(size_t size, size_t alignment) { position_ += cdr_padding(position_, alignment) + size; }

  /// Size of the buffer, header included.
  [[nodiscard]] size_t total() const { return kCdrHeaderSize + position_; }

 private:
  size_t position_ = 0;
};

/// Writes into memory of the caller. After the first write that does not fit all others are
/// ignored.
class CdrWriter {
 public:
  CdrWriter(uint8_t* buffer, size_t capacity) {
    if (capacity < kCdrHeaderSize) {
      ok_ = false;
      return;
    }
    const uint8_t header[kCdrHeaderSize] = {0, 1, 0, 0};
    std::memcpy(buffer, header, kCdrHeaderSize);
    payload_ = buffer + kCdrHeaderSize;
    capacity_ = capacity - kCdrHeaderSize;
  }

  /// Room for `size` bytes at the next multiple of `alignment`; null when it does not fit.
  uint8_t* claim(size_t size, size_t alignment) {
    const size_t padding = cdr_padding(position_, alignment);
    if (!ok_ || padding > capacity_ - position_ || size > capacity_ - position_ - padding) {
      ok_ = false;
      return nullptr;
    }
    for (size_t i = 0; i < padding; ++i) {
      payload_[position_ + i] = 0;
    }
    uint8_t* room = payload_ + position_ + padding;
    position_ += padding + size;
    return room;
  }

  /// Copies bytes that already have their wire form.
  void put_bytes(const void* bytes, size_t size, size_t alignment) {
    uint8_t* room = claim(size, alignment);
    if (room != nullptr && size != 0) {
      std::memcpy(room, bytes, size);
    }
  }

  /// One arithmetic value; a bool is one byte.
  template <class T>
  void put(T value) {
    if (uint8_t* room = claim(sizeof(T), sizeof(T))) {
      std::memcpy(room, &value, sizeof(T));
    }
  }

  /// The 32-bit count in front of a sequence or string.
  [[gnu::noinline]] void put_count(size_t count) {
    if (count > std::numeric_limits<uint32_t>::max()) {
      ok_ = false;
      return;
    }
    put(static_cast<uint32_t>(count));
  }

  void fail() { ok_ = false; }
  [[nodiscard]] bool ok() const { return ok_; }

  /// Bytes written with the header, or 0 when something did not fit.
  [[nodiscard]] size_t finish() const { return ok_ ? kCdrHeaderSize + position_ : 0; }

 private:
  uint8_t* payload_ = nullptr;
  size_t capacity_ = 0;
  size_t position_ = 0;
  bool ok_ = true;
};

/// Reads bytes of unknown origin: never looks past the end, and lets a count ask for memory only
/// when that many elements can still follow. After the first failure all reads fail.
class CdrReader {
 public:
  CdrReader(const uint8_t* buffer, size_t size) {
    // Kinds 0x0000 and 0x0001 are plain CDR, big and little endian; the options are ignored.
    if (buffer == nullptr || size < kCdrHeaderSize || buffer[0] != 0 || buffer[1] > 1) {
      ok_ = false;
      return;
    }
    swapped_ = buffer[1] == 0;
    payload_ = buffer + kCdrHeaderSize;
    size_ = size - kCdrHeaderSize;
  }

  /// `size` bytes at the next multiple of `alignment`; null when there are fewer.
  const uint8_t* take(size_t size, size_t alignment) {
    const size_t padding = cdr_padding(position_, alignment);
    if (!ok_ || padding > size_ - position_ || size > size_ - position_ - padding) {
      ok_ = false;
      return nullptr;
    }
    const uint8_t* bytes = payload_ + position_ + padding;
    position_ += padding + size;
    return bytes;
  }

  /// Copies bytes as they lie; only for values of one byte or when `swapped()` is false.
  void get_bytes(void* target, size_t size, size_t alignment) {
    const uint8_t* bytes = take(size, alignment);
    if (bytes != nullptr && size != 0) {
      std::memcpy(target, bytes, size);
    }
  }

  template <class T>
  void get(T& value) {
    const uint8_t* bytes = take(sizeof(T), sizeof(T));
    if (bytes == nullptr) {
      return;
    }
    if (!swapped_) {
      std::memcpy(&value, bytes, sizeof(T));
      return;
    }
    uint8_t turned[sizeof(T)];
    for (size_t i = 0; i < sizeof(T); ++i) {
      turned[i] = bytes[sizeof(T) - 1 - i];
    }
    std::memcpy(&value, turned, sizeof(T));
  }

  /// A byte other than 0 reads as true.
  void get(bool& value) {
    if (const uint8_t* byte = take(1, 1)) {
      value = *byte != 0;
    }
  }

  /// The count in front of a sequence. Fails, and gives 0, when it exceeds `bound` (0: none) or
  /// when elements of at least `minimum_element_size` bytes (not 0) cannot all be in the rest.
  [[nodiscard, gnu::noinline]] size_t get_count(size_t bound, size_t minimum_element_size) {
    uint32_t count = 0;
    get(count);
    if (!ok_ || (bound != 0 && count > bound) ||
        count > (size_ - position_) / minimum_element_size) {
      ok_ = false;
      return 0;
    }
    return count;
  }

  void fail() { ok_ = false; }
  [[nodiscard]] bool ok() const { return ok_; }
  /// True when the bytes are big-endian.
  [[nodiscard]] bool swapped() const { return swapped_; }

 private:
  const uint8_t* payload_ = nullptr;
  size_t size_ = 0;
  size_t position_ = 0;
  bool swapped_ = false;
  bool ok_ = true;
};

}  // namespace ros2wasm_typesupport
