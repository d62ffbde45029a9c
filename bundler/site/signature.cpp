// See signature.hpp.
#include "bundler/site/signature.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "bundler/io/base64.hpp"
#include "bundler/io/ed25519.hpp"

namespace ros2wasm {
namespace {

constexpr std::string_view kUntrusted = "untrusted comment: ";
constexpr std::string_view kTrusted = "trusted comment: ";
constexpr std::string_view kEd25519 = "Ed";
constexpr std::string_view kPrehashed = "ED";
constexpr std::string_view kScrypt = "Sc";
constexpr std::string_view kNoPassword{"\0\0", 2};
constexpr std::string_view kBlake2b = "B2";
constexpr std::size_t kIdBytes = 8;
constexpr std::size_t kDigestBytes = 64;
constexpr std::size_t kSaltBytes = 32;
constexpr std::size_t kCheckBytes = 32;
constexpr std::size_t kHiddenBytes = kIdBytes + kEd25519SecretBytes + kCheckBytes;
constexpr std::size_t kSecretFileBytes = 2 + 2 + 2 + kSaltBytes + 8 + 8 + kHiddenBytes;
/// minisign's own keys ask for 2^25 and 1 GiB; a file must not ask for more than a machine has.
constexpr std::uint64_t kMostOperations = std::uint64_t{1} << 26U;
constexpr std::uint64_t kMostMemory = std::uint64_t{1} << 31U;
constexpr std::size_t kMostOfAFile = 16'384;
constexpr std::size_t kMostOfAComment = 8'000;

/// The lines of a text with at most `N` of them; a last line may lack its end.
template <std::size_t N>
std::optional<std::array<std::string_view, N>> lines_of(std::string_view text) {
  std::array<std::string_view, N> lines;
  if (text.size() > kMostOfAFile) return std::nullopt;
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos && i + 1 != N) return std::nullopt;
    lines[i] = text.substr(0, end);
    if (lines[i].ends_with('\r')) lines[i].remove_suffix(1);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  if (!text.empty()) return std::nullopt;
  return lines;
}

Diagnostic refusal(DiagnosticCode code, const std::string& shown, const std::string& wanted,
                   std::string why, std::string fix = {}) {
  Diagnostic error{.code = code,
                   .message = "`" + shown + "` is not " + wanted,
                   .why = {std::move(why)},
                   .fix = {}};
  if (!fix.empty()) error.fix.push_back(std::move(fix));
  return error;
}

bool is_plain(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char letter) {
    const auto byte = static_cast<unsigned char>(letter);
    return byte < 0x20 || byte == 0x7F;
  });
}

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < 8; ++i)
    value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
  return value;
}

/// The contents of a secret key's file, before the password is applied.
struct SecretFile {
  bool password = false;
  std::string salt;
  std::uint64_t operations = 0;
  std::uint64_t memory = 0;
  std::string hidden;
};

Outcome<SecretFile> read_secret_file(std::string_view text, const std::string& shown) {
  const auto no_key = [&](std::string why) {
    return refusal("R2W0658", shown, "a secret key of minisign", std::move(why),
                   "make one with `minisign -G`");
  };
  const auto lines = lines_of<2>(text);
  if (!lines || !(*lines)[0].starts_with(kUntrusted))
    return no_key("it has two lines, `untrusted comment: ...` and the key");
  auto bytes = base64_read((*lines)[1]);
  if (!bytes || bytes->size() != kSecretFileBytes)
    return no_key("its second line is not base64 of " + std::to_string(kSecretFileBytes) +
                  " bytes");
  const std::string_view all = *bytes;
  const std::string_view derivation = all.substr(2, 2);
  if (!all.starts_with(kEd25519) || all.substr(4, 2) != kBlake2b ||
      (derivation != kScrypt && derivation != kNoPassword))
    return no_key("it was made for another kind of signature or password");
  SecretFile file{.password = derivation == kScrypt,
                  .salt = std::string(all.substr(6, kSaltBytes)),
                  .operations = little_endian(all.substr(6 + kSaltBytes)),
                  .memory = little_endian(all.substr(14 + kSaltBytes)),
                  .hidden = std::string(all.substr(22 + kSaltBytes))};
  forget(*bytes);
  if (file.password && (file.operations > kMostOperations || file.memory > kMostMemory))
    return no_key("its password would take more time or memory than any key of minisign");
  return file;
}

}  // namespace

SecretKey::~SecretKey() {
  forget(key);
}

std::string key_id_text(std::string_view id) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string text;
  for (std::size_t i = id.size(); i > 0; --i) {
    const auto byte = static_cast<unsigned char>(id[i - 1]);
    text += {kHex[byte >> 4U], kHex[byte & 15U]};
  }
  text.erase(0, std::min(text.find_first_not_of('0'), text.size() - 1));
  return text;
}

Outcome<PublicKey> read_public_key(std::string_view text, const std::string& shown) {
  std::string_view line = text;
  if (const auto lines = lines_of<2>(text); lines && (*lines)[0].starts_with(kUntrusted)) {
    line = (*lines)[1];
  } else if (const auto one = lines_of<1>(text)) {
    line = (*one)[0];
  }
  const auto bytes = base64_read(line);
  if (!bytes || bytes->size() != 2 + kIdBytes + kEd25519PublicBytes ||
      !bytes->starts_with(kEd25519))
    return refusal("R2W0655", shown, "a public key of minisign",
                   "such a key is a line of 56 letters that begins with RW, alone or below "
                   "`untrusted comment: ...`");
  return PublicKey{.id = bytes->substr(2, kIdBytes), .key = bytes->substr(2 + kIdBytes)};
}

std::string public_key_text(const PublicKey& key) {
  return std::string(kUntrusted) + "minisign public key " + key_id_text(key.id) + "\n" +
         base64(std::string(kEd25519) + key.id + key.key) + "\n";
}

Outcome<Signature> read_signature(std::string_view text, const std::string& shown) {
  const auto no_signature = [&](std::string why, std::string fix = {}) {
    return refusal("R2W0656", shown, "a signature of minisign", std::move(why), std::move(fix));
  };
  const auto lines = lines_of<4>(text);
  if (!lines || !(*lines)[0].starts_with(kUntrusted) || !(*lines)[2].starts_with(kTrusted))
    return no_signature(
        "it has four lines: `untrusted comment: ...`, the signature, "
        "`trusted comment: ...` and the signature of both");
  const std::string_view comment = (*lines)[2].substr(kTrusted.size());
  if (comment.size() > kMostOfAComment || !is_plain(comment))
    return no_signature("its trusted comment is too long, or has letters that are not shown");
  const auto first = base64_read((*lines)[1]);
  const auto second = base64_read((*lines)[3]);
  if (!first || first->size() != 2 + kIdBytes + kEd25519SignatureBytes || !second ||
      second->size() != kEd25519SignatureBytes)
    return no_signature("its second or fourth line is not base64 of a signature");
  if (first->starts_with(kEd25519))
    return no_signature("it is of minisign's old kind, which signs the bytes and not their hash",
                        "sign again: minisign 0.11 and `ros2wasm pack --sign` write the new kind");
  if (!first->starts_with(kPrehashed)) return no_signature("it is of a kind that is not known");
  return Signature{.id = first->substr(2, kIdBytes),
                   .bytes = first->substr(2 + kIdBytes),
                   .trusted_comment = std::string(comment),
                   .over_comment = *second};
}

Outcome<Done> check_signature(const Signature& signature, const PublicKey& key,
                              std::string_view message) {
  Diagnostic error{.code = "R2W0657",
                   .message = "the site is not signed with the key that was given",
                   .why = {},
                   .fix = {}};
  if (signature.id != key.id) {
    error.why.push_back("its signature names the key " + key_id_text(signature.id) +
                        ", given was the key " + key_id_text(key.id));
    return error;
  }
  if (!ed25519_verify(blake2b(message, kDigestBytes), signature.bytes, key.key)) {
    error.why.push_back(
        "the signature is of another site.json, or made with another key of the "
        "same id");
    return error;
  }
  if (!ed25519_verify(signature.bytes + signature.trusted_comment, signature.over_comment,
                      key.key)) {
    error.why.push_back("the trusted comment is not the one that was signed");
    return error;
  }
  return Done{};
}

Outcome<bool> wants_password(std::string_view text, const std::string& shown) {
  const auto file = read_secret_file(text, shown);
  if (!file) return file.errors();
  return file->password;
}

Outcome<SecretKey> read_secret_key(std::string_view text, const std::string& shown,
                                   std::string_view password) {
  auto file = read_secret_file(text, shown);
  if (!file) return std::move(file).errors();
  if (file->password) {
    auto stream = scrypt(password, file->salt, file->operations,
                         static_cast<std::size_t>(file->memory), kHiddenBytes);
    if (!stream)
      return Diagnostic{.code = "R2W0659",
                        .kind = FailureKind::kEnvironment,
                        .message = "the key `" + shown + "` could not be opened",
                        .why = {"its password takes " + std::to_string(file->memory >> 20U) +
                                " MB of memory, which are not there"},
                        .fix = {}};
    for (std::size_t i = 0; i < kHiddenBytes; ++i)
      file->hidden[i] = static_cast<char>(file->hidden[i] ^ (*stream)[i]);
    forget(*stream);
  }
  SecretKey secret;
  secret.id = file->hidden.substr(0, kIdBytes);
  secret.key = file->hidden.substr(kIdBytes, kEd25519SecretBytes);
  std::string checked = std::string(kEd25519) + file->hidden.substr(0, kHiddenBytes - kCheckBytes);
  const std::string check = file->hidden.substr(kHiddenBytes - kCheckBytes);
  // `minisign -G -W` leaves the check empty.
  const bool unchecked = !file->password && check == std::string(kCheckBytes, '\0');
  const bool right = unchecked || check == blake2b(checked, kCheckBytes);
  forget(checked);
  forget(file->hidden);
  if (!right && file->password)
    return Diagnostic{.code = "R2W0659",
                      .message = "the key `" + shown + "` could not be opened",
                      .why = {"it has another password"},
                      .fix = {}};
  if (!right || ed25519_public(secret.key) != secret.key.substr(kEd25519PublicBytes))
    return refusal("R2W0658", shown, "a secret key of minisign", "it was changed since it was made",
                   "make one with `minisign -G`");
  return secret;
}

PublicKey public_key_of(const SecretKey& key) {
  return {.id = key.id, .key = key.key.substr(kEd25519PublicBytes)};
}

Outcome<Done> check_trusted_comment(std::string_view comment) {
  if (comment.size() <= kMostOfAComment && is_plain(comment)) return Done{};
  return Diagnostic{.code = "R2W0902",
                    .kind = FailureKind::kCommandLine,
                    .message = "this is not a comment of a signature",
                    .why = {"it is one line of at most " + std::to_string(kMostOfAComment) +
                            " bytes, without control characters"},
                    .fix = {}};
}

std::string signature_text(const SecretKey& key, std::string_view message,
                           std::string_view trusted_comment) {
  const std::string signature = ed25519_sign(blake2b(message, kDigestBytes), key.key);
  const std::string over = ed25519_sign(signature + std::string(trusted_comment), key.key);
  return std::string(kUntrusted) + "signature of the site.json of a ros2wasm site\n" +
         base64(std::string(kPrehashed) + key.id + signature) + "\n" + std::string(kTrusted) +
         std::string(trusted_comment) + "\n" + base64(over) + "\n";
}

}  // namespace ros2wasm
