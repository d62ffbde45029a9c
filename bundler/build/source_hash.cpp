// See source_hash.hpp.
#include "bundler/build/source_hash.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/render/own_site.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

bool counts(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (name.starts_with('.') || name == "__pycache__" || name.ends_with(".pyc")) return false;
  std::error_code error;
  if (!entry.is_directory(error)) return true;
  return !fs::exists(entry.path() / "COLCON_IGNORE", error) && !is_site_of_ours(entry.path());
}

Outcome<std::vector<fs::path>> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (counts(*it)) entries.push_back(it->path());
  }
  if (error) return cannot_read(folder, error.value());
  std::sort(entries.begin(), entries.end());
  return entries;
}

class TreeHash {
 public:
  explicit TreeHash(fs::path root) : root_(std::move(root)) {}

  Outcome<Done> add_folder(const fs::path& folder) {
    std::error_code error;
    const std::string name = name_of(folder);
    // Links may lead round in circles: each folder is read once, and later only named.
    const auto [first, fresh] = read_.emplace(fs::canonical(folder, error), name);
    if (error) return cannot_read(folder, error.value());
    if (!fresh) {
      hash_.add(name, "as " + first->second);
      return Done{};
    }
    const auto entries = sorted_entries(folder);
    if (!entries) return entries.errors();
    for (const fs::path& entry : *entries) {
      Outcome<Done> added = Done{};
      if (fs::is_directory(entry, error)) {
        added = add_folder(entry);
      } else if (fs::is_regular_file(entry, error)) {
        added = add_file(entry);
      }
      if (!added) return added;
    }
    return Done{};
  }

  [[nodiscard]] std::string finish() const { return hash_.finish(); }

 private:
  Outcome<Done> add_file(const fs::path& file) {
    std::error_code error;
    const bool executable =
        (fs::status(file, error).permissions() & fs::perms::owner_exec) != fs::perms::none;
    const auto bytes = read_file(file);
    if (!bytes) return bytes.errors();
    hash_.add(name_of(file), (executable ? "x" : "-") + sha256_hex(*bytes));
    return Done{};
  }

  [[nodiscard]] std::string name_of(const fs::path& path) const {
    return path.lexically_relative(root_).generic_string();
  }

  fs::path root_;
  std::map<fs::path, std::string> read_;  ///< real path -> the name it was read under
  HashBuilder hash_;
};

}  // namespace

Outcome<std::string> hash_of_tree(const fs::path& folder) {
  TreeHash hash(folder);
  if (auto added = hash.add_folder(folder); !added) return std::move(added).errors();
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
