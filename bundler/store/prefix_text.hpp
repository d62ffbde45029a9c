// The prefix that a package was built for, written into its files, is replaced by the one where it
// is now. Pure.
#pragma once

#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Every occurrence.
[[nodiscard]] std::string with_prefix_in_text(std::string_view text, std::string_view placeholder,
                                              std::string_view prefix);

/// Every occurrence in each C string, whose end is filled up with NULs so that nothing moves.
/// R2W0230 when `prefix` is longer than `placeholder`; `path` is for messages.
[[nodiscard]] Outcome<std::string> with_prefix_in_binary(std::string_view bytes,
                                                         std::string_view placeholder,
                                                         std::string_view prefix,
                                                         const std::string& path);

}  // namespace ros2wasm
