// Finds credentials in addresses, so that no message, lock or log shows them. Pure.
#pragma once

#include <string>
#include <string_view>

namespace ros2wasm {

/// The text with every `user:password@` behind `://` and every token of a `/t/TOKEN/` path in an
/// address replaced by `*`, character by character, so that places in it stay where they were. An
/// address of `file:` has no token.
[[nodiscard]] std::string with_masked_secrets(std::string_view text);

/// The address without its credentials: `https://user:pw@host/t/abc/x` is `https://host/x`.
[[nodiscard]] std::string without_secrets(std::string_view url);

/// The parts that without_secrets() removes.
struct AddressSecrets {
  std::string user_info;  ///< "user:password", not decoded; may be empty
  std::string token;      ///< of `/t/TOKEN/`; may be empty
};

[[nodiscard]] AddressSecrets secrets_of(std::string_view url);

}  // namespace ros2wasm
