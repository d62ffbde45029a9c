// See open_site.hpp.
#include "bundler/verify/open_site.hpp"

#include <cerrno>
#include <vector>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

Outcome<OpenSite> open_site(const fs::path& folder) {
  auto text = read_file(folder / kSiteJsonName, kMostOfSiteJson);
  if (!text) return std::move(text).errors();
  auto list = read_site_list(*text, (folder / kSiteJsonName).string());
  if (!list) return std::move(list).errors();
  return OpenSite{.folder = folder, .text = std::move(*text), .list = std::move(*list)};
}

Outcome<std::string> site_bytes(const OpenSite& site, const std::string& path) {
  std::vector<std::string> places{path};
  for (const ListedFile& file : site.list.files) {
    if (file.path == path) places = places_of(file, site.list);
  }
  std::string bytes;
  for (const std::string& place : places) {
    const fs::path root =
        place.starts_with("../") ? site.folder / site.list.store.objects : site.folder;
    const auto file = path_within(root, site.folder / place);
    if (!file) return cannot_read(site.folder / place, ENOENT);
    auto part = read_file(*file, kMostOfData);
    if (!part) return part;
    bytes += *part;
  }
  return bytes;
}

ComparedSite compared(const OpenSite& site) {
  return {site.list, site.text,
          [&site](const std::string& path) { return site_bytes(site, path); }};
}

}  // namespace ros2wasm
