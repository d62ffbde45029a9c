// Talks to the conformance test: reads requests from stdin until its end, answers on stdout.
//   request:  u8 operation, u32 type index, u32 length, bytes
//   answer:   u32 length, JSON text, u32 length, CDR bytes
// Operations: 'l' list the types; 'f' fill a message (bytes: u64 seed); 'd' deserialize the bytes,
// print and serialize again; 'h' feed damaged bytes to the type (bytes: u64 seed).
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "driver.hpp"

namespace {

// Bytes that the type support allocates while it reads: hostile counts must not ask for much.
size_t allocated_bytes = 0;

}  // namespace

void* operator new(size_t size) {
  allocated_bytes += size;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  std::abort();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, size_t) noexcept {
  std::free(memory);
}

namespace driver {
namespace {

using Bytes = std::vector<uint8_t>;
constexpr size_t kHeader = 4;

bool read_exactly(void* target, size_t size) {
  return std::fread(target, 1, size, stdin) == size;
}

void answer(const std::string& json, const Bytes& cdr) {
  const auto put = [](const void* data, size_t size) {
    const auto count = static_cast<uint32_t>(size);
    std::fwrite(&count, 4, 1, stdout);
    std::fwrite(data, 1, size, stdout);
  };
  put(json.data(), json.size());
  put(cdr.data(), cdr.size());
}

/// Serializes and checks what the callbacks promise about sizes.
Bytes serialize(const TypeRow& type, const void* message) {
  const auto* callbacks = type.callbacks();
  const size_t size = callbacks->serialized_size(message);
  Bytes bytes(size);
  if (callbacks->serialize(message, bytes.data(), size) != size) {
    std::fprintf(stderr, "%s: serialized_size is wrong\n", callbacks->type_name);
    std::abort();
  }
  for (size_t capacity = 0; capacity < size; ++capacity) {
    const std::unique_ptr<uint8_t[]> tight(new uint8_t[capacity == 0 ? 1 : capacity]);
    if (callbacks->serialize(message, tight.get(), capacity) != 0) {
      std::fprintf(stderr, "%s: wrote %zu bytes into %zu\n", callbacks->type_name, size, capacity);
      std::abort();
    }
    if (size > 512) capacity += size / 64;
  }
  return bytes;
}

std::string print(const TypeRow& type, const void* message) {
  std::string json;
  type.operations->print(message, json);
  return json;
}

std::string list(const std::vector<TypeRow>& types) {
  std::string json = "[";
  for (const TypeRow& type : types) {
    if (json.size() > 1) json += ',';
    json += std::string("{\"name\":\"") + type.callbacks()->type_name + "\",\"hash\":\"" +
            type.callbacks()->type_hash + "\"}";
  }
  return json + "]";
}

/// Reads a copy in memory of exactly that size, so that a checker sees any byte read behind it.
/// Returns whether it was accepted; stops the program when too much memory was asked for.
bool feed(const TypeRow& type, const uint8_t* bytes, size_t size) {
  const std::unique_ptr<uint8_t[]> tight(new uint8_t[size == 0 ? 1 : size]);
  if (size != 0) std::memcpy(tight.get(), bytes, size);
  const std::shared_ptr<void> message = type.create();
  const size_t before = allocated_bytes;
  const bool accepted = type.callbacks()->deserialize(tight.get(), size, message.get());
  const size_t used = allocated_bytes - before;
  if (used > 4096 + 512 * size) {
    std::fprintf(stderr, "%s: %zu bytes made it allocate %zu\n", type.callbacks()->type_name, size,
                 used);
    std::abort();
  }
  if (accepted) serialize(type, message.get());
  return accepted;
}

std::string feed_damaged(const TypeRow& type, uint64_t seed) {
  Random random(seed);
  const std::shared_ptr<void> message = type.create();
  type.operations->fill(message.get(), random, 0);
  const Bytes good = serialize(type, message.get());
  size_t tried = 0, accepted = 0;
  for (size_t size = 0; size < good.size(); ++size, ++tried) {
    if (feed(type, good.data(), size)) {
      std::fprintf(stderr, "%s: accepted %zu of %zu bytes\n", type.callbacks()->type_name, size,
                   good.size());
      std::abort();
    }
    if (good.size() > 512) size += good.size() / 256;
  }
  for (int round = 0; round < 60; ++round, ++tried) {
    Bytes damaged = good;
    for (size_t hits = 1 + random.below(4); hits > 0; --hits) {
      const size_t place = kHeader + random.below(damaged.size() - kHeader + 1);
      if (place < damaged.size()) damaged[place] = static_cast<uint8_t>(random.next());
    }
    if (random.below(3) == 0) {  // a count as a liar would send it
      const size_t place = kHeader + 4 * random.below((damaged.size() - kHeader) / 4 + 1);
      if (place + 4 <= damaged.size())
        std::memset(&damaged[place], random.below(2) ? 0xFF : 0x7F, 4);
    }
    damaged[1] = static_cast<uint8_t>(random.below(2));  // either byte order
    accepted += feed(type, damaged.data(), damaged.size()) ? 1 : 0;
  }
  for (int round = 0; round < 30; ++round, ++tried) {
    Bytes noise(random.below(200));
    for (uint8_t& byte : noise) byte = static_cast<uint8_t>(random.next());
    if (noise.size() >= kHeader && random.below(4) != 0) noise[0] = 0, noise[1] = 1;
    accepted += feed(type, noise.data(), noise.size()) ? 1 : 0;
  }
  return "{\"tried\":" + std::to_string(tried) + ",\"accepted\":" + std::to_string(accepted) + "}";
}

}  // namespace
}  // namespace driver

int main() {
  using namespace driver;
  const std::vector<TypeRow> types = all_types();
  uint8_t operation = 0;
  while (read_exactly(&operation, 1)) {
    uint32_t index = 0, length = 0;
    if (!read_exactly(&index, 4) || !read_exactly(&length, 4) || index >= types.size()) return 2;
    Bytes bytes(length);
    if (!read_exactly(bytes.data(), length)) return 2;
    const TypeRow& type = types[index];
    uint64_t seed = 0;
    std::memcpy(&seed, bytes.data(), length < 8 ? length : 8);
    const std::shared_ptr<void> message = type.create();
    switch (operation) {
      case 'l':
        answer(list(types), {});
        break;
      case 'f': {
        Random random(seed);
        type.operations->fill(message.get(), random, 0);
        answer(print(type, message.get()), serialize(type, message.get()));
        break;
      }
      case 'd':
        if (type.callbacks()->deserialize(bytes.data(), length, message.get())) {
          answer(print(type, message.get()), serialize(type, message.get()));
        } else {
          answer("null", {});
        }
        break;
      case 'h':
        answer(feed_damaged(type, seed), {});
        break;
      default:
        return 2;
    }
  }
  return 0;
}
