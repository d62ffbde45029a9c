// Folders that are made once and then kept, such as installed packages: made beside, renamed into
// place, and trusted only with the stamp that was written last. A half copied or half removed one
// is made again. An edge to the disk.
#pragma once

#include <filesystem>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The stamp, directly in the folder.
inline constexpr const char* kKeptStamp = ".ros2wasm-complete";

/// Is `folder` whole, and made for `key`?
[[nodiscard]] bool is_kept(const std::filesystem::path& folder, std::string_view key);

/// Stamps `made` with `key` and puts it at `folder`, in the place of one that is not whole. When
/// somebody else was faster, theirs stays: the same key has the same files. R2W0211.
[[nodiscard]] Outcome<Done> keep_folder(const std::filesystem::path& made,
                                        const std::filesystem::path& folder, std::string_view key);

}  // namespace ros2wasm
