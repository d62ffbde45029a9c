// Ed25519, BLAKE2b and scrypt, as minisign uses them. libsodium ends in ed25519.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

inline constexpr std::size_t kEd25519PublicBytes = 32;
inline constexpr std::size_t kEd25519SecretBytes = 64;  ///< the seed, then the public key
inline constexpr std::size_t kEd25519SignatureBytes = 64;

/// Its digest of `size` bytes, 16 to 64.
[[nodiscard]] std::string blake2b(std::string_view bytes, std::size_t size);

/// `secret_key` has kEd25519SecretBytes bytes.
[[nodiscard]] std::string ed25519_sign(std::string_view message, std::string_view secret_key);

/// False for keys and signatures of other sizes too.
[[nodiscard]] bool ed25519_verify(std::string_view message, std::string_view signature,
                                  std::string_view public_key);

/// The public key that a secret key's seed gives.
[[nodiscard]] std::string ed25519_public(std::string_view secret_key);

/// scrypt by libsodium's measures of time and memory. Nothing when the memory is not there.
[[nodiscard]] std::optional<std::string> scrypt(std::string_view password, std::string_view salt,
                                                std::uint64_t operations, std::size_t memory_bytes,
                                                std::size_t size);

/// Overwrites what must not stay in memory.
void forget(std::string& secret);

}  // namespace ros2wasm
