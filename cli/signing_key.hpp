// The key that signs a site: from its file, with a password from a file descriptor, the environment
// or the terminal.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "bundler/plan/site_signature.hpp"
#include "cli/context.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct SigningChoice {
  std::string key_file;  ///< empty: the site is not signed
  std::string comment;
  std::optional<int> password_fd;
};

/// Null when no key is chosen. R2W0210, R2W0658, R2W0659, R2W0902.
[[nodiscard]] Outcome<std::shared_ptr<const SiteSigner>> read_signer(const SigningChoice& choice,
                                                                     const Context& context);

}  // namespace ros2wasm
