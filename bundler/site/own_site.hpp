// Which folders, archives and pages ros2wasm made: they may be replaced, and are not sources. Which
// stores it made: those may be served.
#pragma once

#include <filesystem>
#include <string_view>

namespace ros2wasm {

/// By its `generator`.
[[nodiscard]] bool is_site_json_of_ours(std::string_view text);

/// By its site.json.
[[nodiscard]] bool is_site_of_ours(const std::filesystem::path& folder);

/// By its course.json, unless it is a site.
[[nodiscard]] bool is_course_of_ours(const std::filesystem::path& folder);

/// By its marker (kStoreMarker), and by nothing else: others have folders with hashes as names,
/// too.
[[nodiscard]] bool is_store_of_ours(const std::filesystem::path& folder);

/// By its first member, which emit_zip() makes the site.json.
[[nodiscard]] bool is_site_archive_of_ours(const std::filesystem::path& file);

/// By its first lines, which emit_page() writes.
[[nodiscard]] bool is_site_page_of_ours(const std::filesystem::path& file);

}  // namespace ros2wasm
