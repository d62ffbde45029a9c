// See sha256.hpp. OpenSSL is known here only.
#include "bundler/io/sha256.hpp"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <functional>
#include <vector>

#include "bundler/io/files.hpp"
#include "workspace_schema/base/text_pattern.hpp"

namespace ros2wasm {

struct Hasher::State {
  EVP_MD_CTX* context = EVP_MD_CTX_new();
  State() = default;
  ~State() { EVP_MD_CTX_free(context); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;
};

Hasher::Hasher(HashKind kind) : state_(std::make_unique<State>()) {
  EVP_DigestInit_ex(state_->context, kind == HashKind::kSha256 ? EVP_sha256() : EVP_md5(), nullptr);
}
Hasher::~Hasher() = default;
Hasher::Hasher(Hasher&&) noexcept = default;
Hasher& Hasher::operator=(Hasher&&) noexcept = default;

void Hasher::add(std::string_view bytes) {
  EVP_DigestUpdate(state_->context, bytes.data(), bytes.size());
}

std::string Hasher::hex() {
  std::array<char, EVP_MAX_MD_SIZE> digest{};
  unsigned length = 0;
  EVP_DigestFinal_ex(state_->context, reinterpret_cast<unsigned char*>(digest.data()),  // NOLINT
                     &length);
  return hex_text({digest.data(), length});
}

std::string sha256_hex(std::string_view bytes) {
  Hasher hasher;
  hasher.add(bytes);
  return hasher.hex();
}

namespace {

Outcome<Done> read_pieces(const std::filesystem::path& path,
                          const std::function<void(std::string_view)>& take) {
  const auto opened = open_file_to_read(path);
  if (!opened) return opened.errors();
  const int fd = *opened;
  std::vector<char> buffer(std::size_t{256} * 1024);
  for (;;) {
    const ssize_t got = ::read(fd, buffer.data(), buffer.size());
    if (got < 0) {
      const int failed = errno;
      if (failed == EINTR) continue;
      ::close(fd);
      return cannot_read(path, failed);
    }
    if (got == 0) break;
    take(std::string_view(buffer.data(), static_cast<std::size_t>(got)));
  }
  ::close(fd);
  return Done{};
}

}  // namespace

Outcome<FileHashes> hash_file(const std::filesystem::path& path, bool with_md5) {
  Hasher sha256;
  Hasher md5(HashKind::kMd5);
  FileHashes hashes;
  const auto read = read_pieces(path, [&](std::string_view piece) {
    sha256.add(piece);
    if (with_md5) md5.add(piece);
    hashes.size += piece.size();
  });
  if (!read) return read.errors();
  hashes.sha256 = sha256.hex();
  if (with_md5) hashes.md5 = md5.hex();
  return hashes;
}

Outcome<FileHashes> hash_parts(const std::vector<std::filesystem::path>& parts,
                               std::uint64_t at_most) {
  FileHashes hashes;
  for (const auto& part : parts) {
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(part, error);
    hashes.size += error ? 0 : size;  // read_pieces() says why it cannot be read
  }
  if (hashes.size > at_most) return hashes;
  hashes.size = 0;
  Hasher sha256;
  for (const auto& part : parts) {
    const auto read = read_pieces(part, [&](std::string_view piece) {
      sha256.add(piece);
      hashes.size += piece.size();
    });
    if (!read) return read.errors();
  }
  hashes.sha256 = sha256.hex();
  return hashes;
}

}  // namespace ros2wasm
