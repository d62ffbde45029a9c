// Names and first lines by which a site, a course and a page that carries a site are known.
#pragma once

#include <cstdint>
#include <string_view>

namespace ros2wasm {

/// `generator` of every site.json and course.json begins with it.
inline constexpr std::string_view kSiteGenerator = "ros2wasm";

inline constexpr const char* kSiteJsonName = "site.json";
inline constexpr const char* kCourseJsonName = "course.json";
/// Bytes; a site of 100,000 files has less.
inline constexpr std::uint64_t kMostOfSiteJson = std::uint64_t{64} << 20U;

/// The file of a site that lists its files, site.json too, for `sha256sum --check`.
inline constexpr const char* kHashList = "SHA256SUMS";
inline constexpr const char* kHashListReason = "hashes of all files, for `sha256sum --check`";
/// The archive of the sources of the site; see carried_sources.hpp.
inline constexpr const char* kSourcesArchive = "sources.zip";

/// A site in one page begins with these two, and then with `kSiteGenerator`.
inline constexpr std::string_view kCarriedPageDoctype = "<!doctype html>\n";
inline constexpr std::string_view kCarriedPageMark = "<!-- site of ";

/// By its first lines.
[[nodiscard]] constexpr bool is_carried_page(std::string_view page) {
  for (const std::string_view part : {kCarriedPageDoctype, kCarriedPageMark, kSiteGenerator}) {
    if (!page.starts_with(part)) return false;
    page.remove_prefix(part.size());
  }
  return true;
}

}  // namespace ros2wasm
