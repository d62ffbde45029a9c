// See own_site.hpp.
#include "bundler/site/own_site.hpp"

#include <cstdint>
#include <fstream>

#include "bundler/io/files.hpp"
#include "bundler/site/site_names.hpp"
#include "bundler/site/site_place.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

std::uint32_t number_at(std::string_view header, std::size_t at, int bytes) {
  std::uint32_t value = 0;
  for (int i = 0; i < bytes; ++i)
    value |= std::uint32_t{static_cast<unsigned char>(header[at + i])} << (8 * i);
  return value;
}

/// The first member of an archive of ours, when it has that name; else empty.
std::string first_member(const fs::path& file, std::string_view name) {
  constexpr std::size_t kHeader = 30;
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return {};
  std::ifstream in(file, std::ios::binary);
  std::string header(kHeader + name.size(), '\0');
  if (!in.read(header.data(), static_cast<std::streamsize>(header.size()))) return {};
  const std::uint32_t size = number_at(header, 22, 4);
  if (!header.starts_with("PK\3\4") || number_at(header, 8, 2) != 0 ||
      number_at(header, 26, 2) != name.size() || number_at(header, 28, 2) != 0 ||
      !header.ends_with(name) || size > kMostOfSiteJson)
    return {};
  std::string text(size, '\0');
  if (!in.read(text.data(), static_cast<std::streamsize>(size))) return {};
  return text;
}

}  // namespace

bool is_site_json_of_ours(std::string_view text) {
  const auto json = parse_json(text, "site.json", "R2W0605");
  return json && json->text_of("generator").starts_with(kSiteGenerator);
}

bool is_site_of_ours(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / "site.json", error)) return false;
  const auto text = read_file(folder / "site.json", kMostOfSiteJson);
  return text && is_site_json_of_ours(*text);
}

bool is_course_of_ours(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_regular_file(folder / kCourseJsonName, error)) return false;
  // One with a site.json is a site, whose files a course.json must not hide.
  if (fs::exists(fs::symlink_status(folder / "site.json", error))) return false;
  const auto text = read_file(folder / kCourseJsonName, kMostOfList);
  return text && is_site_json_of_ours(*text);
}

bool is_store_of_ours(const fs::path& folder) {
  std::error_code error;
  const fs::path marker = folder / kStoreMarker;
  if (!fs::is_regular_file(fs::symlink_status(marker, error))) return false;
  const auto text = read_file(marker, kMostOfText);
  return text && *text == kStoreMarkerText;
}

bool is_site_archive_of_ours(const fs::path& file) {
  return is_site_json_of_ours(first_member(file, kSiteJsonName)) ||
         is_site_json_of_ours(first_member(file, kCourseJsonName));
}

bool is_site_page_of_ours(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  std::ifstream in(file, std::ios::binary);
  std::string first(64, '\0');
  return in.read(first.data(), static_cast<std::streamsize>(first.size())) &&
         is_carried_page(first);
}

}  // namespace ros2wasm
