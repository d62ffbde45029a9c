// See package_lists.hpp.
#include "bundler/archive/package_lists.hpp"

#include <utility>

#include "bundler/io/files.hpp"

namespace ros2wasm {

Outcome<PackageLists> read_package_lists(const std::filesystem::path& folder) {
  PackageLists lists;
  for (const auto& [name, text] :
       {std::pair("info/paths.json", &lists.paths_json), std::pair("info/files", &lists.files),
        std::pair("info/has_prefix", &lists.has_prefix)}) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(folder / name, error)) continue;
    auto read = read_file(folder / name, kMostOfList);
    if (!read) return std::move(read).errors();
    *text = std::move(*read);
  }
  return lists;
}

}  // namespace ros2wasm
