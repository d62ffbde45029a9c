// A site's list of its own files, in its site.json. Pure; the text is untrusted.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/site/site_names.hpp"
#include "bundler/site/site_place.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct ListedFile {
  std::string path;  ///< relative to the site, with `/`; leads nowhere else
  std::uint64_t size = 0;
  std::string sha256;  ///< 64 hex digits
  std::string reason;
  Kept kept = Kept::kBeside;
  std::vector<FilePart> parts = {};  ///< of that size together
};

struct SiteList {
  std::string hash;  ///< sha256 of site.json: of all files by their hashes, so of the whole site
  std::string generator;
  std::string carried_page_sha256;  ///< of the page that `pack -o NAME.html` puts files into
  std::vector<ListedFile> files;    ///< in the order of the text
  SiteStore store = {};
};

/// Relative to site.json, in the order of its parts.
[[nodiscard]] std::vector<std::string> places_of(const ListedFile& file, const SiteList& list);

/// `shown` names the text in diagnostics. R2W0605 not a site.json of ours, R2W0608 a path that
/// leads out of the site.
[[nodiscard]] Outcome<SiteList> read_site_list(std::string_view site_json,
                                               const std::string& shown);

/// A path in an address.
[[nodiscard]] std::string percent_encoded(std::string_view path);

/// The text of its SHA256SUMS.
[[nodiscard]] std::string hash_list(const SiteList& list);

/// Place -> sha256.
using PlaceHashes = std::map<std::string, std::string>;

/// The files of the site that is the folder `name` of a course, with its site.json, where they are
/// in the course.
[[nodiscard]] PlaceHashes places_of_lab(const SiteList& list, const std::string& name);

/// A text for `sha256sum --check`.
[[nodiscard]] std::string hash_list(const PlaceHashes& files);

}  // namespace ros2wasm
