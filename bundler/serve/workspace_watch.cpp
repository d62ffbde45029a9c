// See workspace_watch.hpp.
#include "bundler/serve/workspace_watch.hpp"

#include <dirent.h>
#include <sys/stat.h>

#include <algorithm>
#include <set>
#include <utility>

namespace ros2wasm {
namespace {

using FolderIdentity = std::pair<dev_t, ino_t>;

struct Walk {
  std::set<FolderIdentity> visited;  ///< starts with the ignored ones
  WorkspaceMarks marks;
};

std::optional<struct stat> status_of(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

std::vector<std::string> names_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  DIR* const stream = opendir(folder.c_str());
  if (stream == nullptr) return names;
  while (const dirent* entry = readdir(stream)) names.emplace_back(entry->d_name);
  closedir(stream);
  std::sort(names.begin(), names.end());
  return names;
}

void walk(const std::filesystem::path& path, Walk& state) {
  const auto status = status_of(path);
  if (!status) return;  // gone meanwhile, or a link to nowhere
  if (S_ISREG(status->st_mode)) {
    const std::int64_t modified_ns =
        std::int64_t{status->st_mtim.tv_sec} * 1'000'000'000 + status->st_mtim.tv_nsec;
    state.marks[path.string()] = FileMark{.size = static_cast<std::uint64_t>(status->st_size),
                                          .inode = status->st_ino,
                                          .modified_ns = modified_ns};
  }
  if (!S_ISDIR(status->st_mode) || !state.visited.emplace(status->st_dev, status->st_ino).second)
    return;
  const auto names = names_in(path);
  std::error_code error;
  if (std::find(names.begin(), names.end(), "COLCON_IGNORE") != names.end()) return;
  for (const std::string& name : names) {
    const bool hidden_folder =
        name.starts_with('.') && std::filesystem::is_directory(path / name, error);
    if (!hidden_folder) walk(path / name, state);
  }
}

std::optional<std::string> first_difference(const WorkspaceMarks& a, const WorkspaceMarks& b) {
  const auto [left, right] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (left == a.end() && right == b.end()) return std::nullopt;
  if (left == a.end()) return right->first;
  if (right == b.end()) return left->first;
  return std::min(left->first, right->first);
}

}  // namespace

WorkspaceMarks workspace_marks(const std::vector<std::filesystem::path>& roots,
                               const std::vector<std::filesystem::path>& ignored) {
  Walk state;
  for (const auto& folder : ignored) {
    if (const auto status = status_of(folder))
      state.visited.emplace(status->st_dev, status->st_ino);
  }
  for (const auto& root : roots) walk(root, state);
  return std::move(state.marks);
}

std::optional<std::string> WorkspaceWatch::look(WorkspaceMarks now) {
  auto changed = first_difference(packed_, now);
  const bool still = now == last_;
  last_ = std::move(now);
  if (!changed || !still) return std::nullopt;
  packed_ = last_;
  return changed;
}

void WorkspaceWatch::accept(const WorkspaceMarks& written) {
  for (const auto& [path, mark] : written) {
    packed_[path] = mark;
    last_[path] = mark;
  }
}

}  // namespace ros2wasm
