// See cached_folder.hpp.
#include "bundler/io/cached_folder.hpp"

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;

bool is_kept(const fs::path& folder, std::string_view key) {
  std::error_code error;
  if (!fs::is_regular_file(folder / kKeptStamp, error)) return false;
  const auto stamp = read_file(folder / kKeptStamp, kMostOfText);
  return stamp && *stamp == key;
}

Outcome<Done> keep_folder(const fs::path& made, const fs::path& folder, std::string_view key) {
  if (auto stamped = write_file(made / kKeptStamp, key); !stamped) return stamped;
  std::error_code error;
  if (fs::exists(folder, error) && !is_kept(folder, key)) {
    if (auto removed = remove_tree(folder); !removed) return removed;
  }
  fs::rename(made, folder, error);
  if (error && !is_kept(folder, key)) return cannot_write(folder, error.value());
  return Done{};
}

}  // namespace ros2wasm
