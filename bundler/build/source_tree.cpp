// See source_tree.hpp.
#include "bundler/build/source_tree.hpp"

#include <algorithm>
#include <map>

#include "bundler/io/files.hpp"
#include "bundler/site/own_site.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

bool counts(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  if (name.starts_with('.') || name == "__pycache__" || name.ends_with(".pyc")) return false;
  std::error_code error;
  if (!entry.is_directory(error))
    return !(name.ends_with(".zip") && is_site_archive_of_ours(entry.path())) &&
           !(name.ends_with(".html") && is_site_page_of_ours(entry.path()));
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

class TreeWalk {
 public:
  TreeWalk(fs::path root, fs::path workspace, std::size_t most)
      : root_(std::move(root)), workspace_(std::move(workspace)), most_(most) {}

  Outcome<Done> add_folder(const fs::path& folder) {
    std::error_code error;
    const std::string path = path_of(folder);
    // Links may lead round in circles: each folder is read once, and later only named.
    const auto [first, fresh] = read_.emplace(fs::canonical(folder, error), path);
    if (error) return cannot_read(folder, error.value());
    found_.push_back(
        {.path = path, .is_folder = true, .same_as = fresh ? "" : first->second, .leads_to = {}});
    if (!fresh) return Done{};
    const auto entries = sorted_entries(folder);
    if (!entries) return entries.errors();
    for (const fs::path& entry : *entries) {
      if (found_.size() >= most_) break;
      const bool is_folder = fs::is_directory(entry, error);
      if (is_folder && fs::is_symlink(entry, error) && leads_out(entry)) {
        found_.push_back({.path = path_of(entry),
                          .is_folder = true,
                          .same_as = {},
                          .leads_to = fs::read_symlink(entry, error).generic_string()});
        if (error) return cannot_read(entry, error.value());
      } else if (is_folder) {
        if (auto added = add_folder(entry); !added) return added;
      } else if (fs::is_regular_file(entry, error)) {
        found_.push_back(
            {.path = path_of(entry), .is_folder = false, .same_as = {}, .leads_to = {}});
      }
    }
    return Done{};
  }

  [[nodiscard]] std::vector<SourceEntry> found() && { return std::move(found_); }

 private:
  /// Such a link may lead to all of this machine's files, which are no part of any package.
  [[nodiscard]] bool leads_out(const fs::path& link) const {
    return !path_within(root_, link) && (workspace_.empty() || !path_within(workspace_, link));
  }

  [[nodiscard]] std::string path_of(const fs::path& path) const {
    return path.lexically_relative(root_).generic_string();
  }

  fs::path root_;
  fs::path workspace_;
  std::size_t most_;
  std::map<fs::path, std::string> read_;  ///< real path -> the path it was read under
  std::vector<SourceEntry> found_;
};

}  // namespace

Outcome<std::vector<SourceEntry>> source_tree(const fs::path& folder, const fs::path& workspace,
                                              std::size_t most) {
  TreeWalk walk(folder, workspace, most);
  if (auto added = walk.add_folder(folder); !added) return std::move(added).errors();
  return std::move(walk).found();
}

}  // namespace ros2wasm
