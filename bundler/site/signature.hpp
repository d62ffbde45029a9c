// Keys and signatures of sites, in minisign's format: what `minisign -G`, `-S` and `-V` read and
// write. Pure; public keys and signatures may be anybody's.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Beside the site.json that it signs, as `minisign -V -m site.json` looks for it.
inline constexpr const char* kSignatureName = "site.json.minisig";
/// The key that it was made with, for whoever compares it with what the author says elsewhere.
inline constexpr const char* kPublicKeyName = "minisign.pub";

struct PublicKey {
  std::string id;   ///< 8 bytes
  std::string key;  ///< 32 bytes
};

struct SecretKey {
  std::string id;
  std::string key;  ///< 64 bytes

  SecretKey() = default;
  SecretKey(SecretKey&&) = default;
  SecretKey& operator=(SecretKey&&) = default;
  SecretKey(const SecretKey&) = delete;
  SecretKey& operator=(const SecretKey&) = delete;
  ~SecretKey();
};

struct Signature {
  std::string id;
  std::string bytes;            ///< 64, over BLAKE2b-512 of what is signed
  std::string trusted_comment;  ///< signed too
  std::string over_comment;     ///< 64 bytes
};

/// As minisign writes it: a number in hex, the last byte first, without zeros before it.
[[nodiscard]] std::string key_id_text(std::string_view id);

/// A key's file, or its line of base64 alone. R2W0655.
[[nodiscard]] Outcome<PublicKey> read_public_key(std::string_view text, const std::string& shown);
[[nodiscard]] std::string public_key_text(const PublicKey& key);

/// R2W0656.
[[nodiscard]] Outcome<Signature> read_signature(std::string_view text, const std::string& shown);

/// R2W0657 the signature is by another key, of other bytes, or its trusted comment is changed.
[[nodiscard]] Outcome<Done> check_signature(const Signature& signature, const PublicKey& key,
                                            std::string_view message);

/// Whether a secret key's file wants a password. R2W0658.
[[nodiscard]] Outcome<bool> wants_password(std::string_view text, const std::string& shown);

/// `password` is not looked at when the file wants none. R2W0658 no key, R2W0659 the password is
/// another.
[[nodiscard]] Outcome<SecretKey> read_secret_key(std::string_view text, const std::string& shown,
                                                 std::string_view password);

[[nodiscard]] PublicKey public_key_of(const SecretKey& key);

/// A text of one line, of at most 8000 bytes. R2W0902.
[[nodiscard]] Outcome<Done> check_trusted_comment(std::string_view comment);

/// The signature file of `message`: the same for the same arguments.
[[nodiscard]] std::string signature_text(const SecretKey& key, std::string_view message,
                                         std::string_view trusted_comment);

}  // namespace ros2wasm
