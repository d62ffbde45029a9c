// Any text as a signature or a key: refused, or read; never a signature of what nobody signed.
#include "bundler/site/signature.hpp"
#include "tests/fuzz/require.hpp"

using namespace ros2wasm;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = fuzz::text_of(data, size);
  if (const auto key = read_public_key(text, "minisign.pub")) {
    const auto again = read_public_key(public_key_text(*key), "minisign.pub");
    fuzz::require(again.ok() && again->id == key->id && again->key == key->key,
                  "a key that is written can be read");
  }
  if (const auto signature = read_signature(text, "site.json.minisig")) {
    const PublicKey key{.id = signature->id, .key = std::string(32, 'k')};
    fuzz::require(!check_signature(*signature, key, "a site").ok(), "nobody signed it");
    fuzz::require(signature->trusted_comment.find('\n') == std::string::npos, "one line");
  }
  // A password would cost a second.
  const auto wants = wants_password(text, "minisign.key");
  if (wants && !*wants) static_cast<void>(read_secret_key(text, "minisign.key", ""));
  return 0;
}
