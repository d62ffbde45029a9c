// The contents of a folder, as one text: every path with its kind and sha256. Two folders with the
// same seal have the same contents. An edge: it reads every file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// One line per entry, sorted by path, but for the one at `except`. Files are read in parallel.
/// R2W0210, R2W0903.
[[nodiscard]] Outcome<std::string> tree_seal(const std::filesystem::path& root,
                                             std::string_view except,
                                             const Cancellation& cancellation);

}  // namespace ros2wasm
