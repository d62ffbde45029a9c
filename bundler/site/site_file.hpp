// The files of a site as values: their bytes, hashes, places and the reason they are there. Pure.
#pragma once

#include <string>
#include <vector>

#include "bundler/site/site_place.hpp"

namespace ros2wasm {

struct PlannedFile {
  std::string path;  ///< relative to the site, with `/`
  std::string reason;
  std::string bytes;
  std::string sha256;
  Kept kept = Kept::kBeside;
  std::vector<FilePart> parts = {};  ///< when it is not in one piece
};

/// The text of SHA256SUMS. `files` in their order there.
[[nodiscard]] std::string hash_list(const std::vector<PlannedFile>& files);

/// A file of the workspace that the page shows.
struct PageFile {
  std::string path;  ///< relative to the manifest, with `/`, within its folder
  std::string bytes;
};

/// Where the site has it: below `text/`.
[[nodiscard]] std::string page_text_path(const std::string& path);
/// The same for bags: below `bags/`.
[[nodiscard]] std::string page_bag_path(const std::string& path);

}  // namespace ros2wasm
