// The files of a package as builds see them. An edge: reads folders.
#pragma once

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct SourceEntry {
  std::string path;  ///< relative to the folder, which is "." itself
  bool is_folder = false;
  std::string same_as;   ///< of a folder whose files came before: the path that they came under
  std::string leads_to;  ///< of a link to a folder elsewhere, which is not walked: as it is written
};

/// All folders and files below `folder`, each folder before what is in it. Hidden files, Python
/// caches, folders that hold COLCON_IGNORE and sites that ros2wasm made, as folders or archives, do
/// not count. Links are followed within `folder` and `workspace`, which may be empty; a folder that
/// several names lead to is read once. Ends early when `most` are found. R2W0210.
[[nodiscard]] Outcome<std::vector<SourceEntry>> source_tree(
    const std::filesystem::path& folder, const std::filesystem::path& workspace = {},
    std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace ros2wasm
