// See ed25519.hpp. libsodium is known here only.
#include "bundler/io/ed25519.hpp"

#include <sodium.h>

#include <cassert>

namespace ros2wasm {
namespace {

const unsigned char* bytes_of(std::string_view text) {
  return reinterpret_cast<const unsigned char*>(text.data());  // NOLINT
}

unsigned char* room_of(std::string& text) {
  return reinterpret_cast<unsigned char*>(text.data());  // NOLINT
}

}  // namespace

std::string blake2b(std::string_view bytes, std::size_t size) {
  std::string digest(size, '\0');
  const int failed =
      ::crypto_generichash(room_of(digest), size, bytes_of(bytes), bytes.size(), nullptr, 0);
  assert(failed == 0);
  static_cast<void>(failed);
  return digest;
}

std::string ed25519_sign(std::string_view message, std::string_view secret_key) {
  assert(secret_key.size() == kEd25519SecretBytes);
  std::string signature(kEd25519SignatureBytes, '\0');
  ::crypto_sign_detached(room_of(signature), nullptr, bytes_of(message), message.size(),
                         bytes_of(secret_key));
  return signature;
}

bool ed25519_verify(std::string_view message, std::string_view signature,
                    std::string_view public_key) {
  return signature.size() == kEd25519SignatureBytes && public_key.size() == kEd25519PublicBytes &&
         ::crypto_sign_verify_detached(bytes_of(signature), bytes_of(message), message.size(),
                                       bytes_of(public_key)) == 0;
}

std::string ed25519_public(std::string_view secret_key) {
  assert(secret_key.size() == kEd25519SecretBytes);
  std::string key(kEd25519PublicBytes, '\0');
  std::string whole(kEd25519SecretBytes, '\0');
  ::crypto_sign_seed_keypair(room_of(key), room_of(whole), bytes_of(secret_key));
  forget(whole);
  return key;
}

std::optional<std::string> scrypt(std::string_view password, std::string_view salt,
                                  std::uint64_t operations, std::size_t memory_bytes,
                                  std::size_t size) {
  assert(salt.size() == crypto_pwhash_scryptsalsa208sha256_SALTBYTES);
  std::string stream(size, '\0');
  if (::crypto_pwhash_scryptsalsa208sha256(room_of(stream), size, password.data(), password.size(),
                                           bytes_of(salt), operations, memory_bytes) != 0)
    return std::nullopt;
  return stream;
}

void forget(std::string& secret) {
  ::sodium_memzero(secret.data(), secret.size());
  secret.clear();
}

}  // namespace ros2wasm
