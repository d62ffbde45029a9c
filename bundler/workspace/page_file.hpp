// The conditions for files of the workspace to become files of the page (`ui: text:`, `ui: bags:`).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

inline constexpr const char* kNotInFolder = "it is not in the folder of the manifest";

/// R2W0118 for the file that the manifest names, or one that that file names.
[[nodiscard]] Diagnostic page_file_refused(const Spanned<std::string>& file,
                                           const std::string& path, std::string why);

/// True when a normalized path leads out of its folder. Pure.
[[nodiscard]] bool leaves_folder(const std::string& path);

/// Where the file really is: a regular one within the folder, whatever links lead to it. R2W0118.
/// An edge: looks at files.
[[nodiscard]] Outcome<std::filesystem::path> find_page_file(const std::filesystem::path& folder,
                                                            const Spanned<std::string>& file,
                                                            const std::string& path);

}  // namespace ros2wasm
