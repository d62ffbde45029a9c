// Rules for the names in archives: which names and link targets may be written below a folder, and
// which files are programs that conda would run. Names only, but for link_ends_inside().
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ros2wasm {

/// The name as a clean relative path: without leading `./`, doubled or ending `/`. Nothing when it
/// is absolute, empty, has a `..` part, a control character or a NUL, i.e. when it may not be
/// written.
[[nodiscard]] std::optional<std::string> safe_member_path(std::string_view name);

/// Whether a symbolic link at `path` (clean, relative) to `target` ends inside the root, by names
/// alone.
[[nodiscard]] bool link_stays_inside(std::string_view path, std::string_view target);

/// Whether the link at `path` below `root` ends inside it when other links on its way are followed
/// too: each alone may stay inside by its name and lead out with another. Reads the disk; what is
/// not there counts by its name.
[[nodiscard]] bool link_ends_inside(const std::filesystem::path& root, const std::string& path);

/// The package whose installation conda would run this file at: "x" for `bin/.x-post-link.sh`.
/// Nothing for other files.
[[nodiscard]] std::optional<std::string> link_script_package(std::string_view path);

}  // namespace ros2wasm
