// See source_hash.hpp.
#include "bundler/build/source_hash.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

bool counts(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (name.starts_with('.') || name == "__pycache__" || name.ends_with(".pyc")) return false;
  std::error_code error;
  if (!entry.is_directory(error)) return true;
  return !fs::exists(entry.path() / "COLCON_IGNORE", error) &&
         !fs::exists(entry.path() / "site.json", error);
}

void collect(const fs::path& folder, std::vector<fs::path>& files, int depth) {
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    if (!counts(*it)) continue;
    if (it->is_directory(ignored)) {
      folders.push_back(it->path());
    } else if (it->is_regular_file(ignored)) {
      files.push_back(it->path());
    }
  }
  constexpr int kDepthLimit = 64;  // links that lead round in circles end here
  if (depth >= kDepthLimit) return;
  for (const fs::path& inner : folders) collect(inner, files, depth + 1);
}

}  // namespace

std::string hash_of_tree(const fs::path& folder) {
  std::vector<fs::path> files;
  collect(folder, files, 0);
  std::sort(files.begin(), files.end());
  HashBuilder hash;
  for (const fs::path& file : files) {
    std::error_code error;
    const bool executable =
        (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    const auto bytes = read_file(file);
    hash.add(file.lexically_relative(folder).generic_string(),
             (executable ? "x" : "-") + sha256_hex(bytes ? *bytes : std::string()));
  }
  return hash.finish();
}

HashBuilder& HashBuilder::add(std::string_view name, std::string_view value) {
  // Lengths keep ("ab", "c") and ("a", "bc") apart.
  text_ += std::to_string(name.size()) + ":" + std::to_string(value.size()) + ":";
  text_.append(name).append(value);
  return *this;
}

std::string HashBuilder::finish() const {
  return sha256_hex(text_);
}

}  // namespace ros2wasm
