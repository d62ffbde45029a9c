// SHA-256 (and MD5, which old channels still use), as lower-case hex. OpenSSL ends in sha256.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class HashKind { kSha256, kMd5 };

/// Fed in pieces.
class Hasher {
 public:
  explicit Hasher(HashKind kind = HashKind::kSha256);
  ~Hasher();
  Hasher(Hasher&&) noexcept;
  Hasher& operator=(Hasher&&) noexcept;

  void add(std::string_view bytes);
  /// The digest in hex; nothing may be added afterwards.
  [[nodiscard]] std::string hex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

[[nodiscard]] std::string sha256_hex(std::string_view bytes);

struct FileHashes {
  std::string sha256;
  std::string md5;
  std::uint64_t size = 0;
};

/// Reads a file once. R2W0210.
[[nodiscard]] Outcome<FileHashes> hash_file(const std::filesystem::path& path,
                                            bool with_md5 = false);

/// The sha256 of all parts, one after the other. Nothing is read when they have more than `at_most`
/// bytes: `sha256` is empty then. For files of strangers, which can have holes of terabytes.
/// R2W0210.
[[nodiscard]] Outcome<FileHashes> hash_parts(const std::vector<std::filesystem::path>& parts,
                                             std::uint64_t at_most);

}  // namespace ros2wasm
