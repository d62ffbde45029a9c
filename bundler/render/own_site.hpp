// Which folders are sites that ros2wasm made: they may be replaced, and are no sources.
#pragma once

#include <filesystem>

namespace ros2wasm {

/// By its site.json.
[[nodiscard]] bool is_site_of_ours(const std::filesystem::path& folder);

}  // namespace ros2wasm
