// See python_sources.hpp.
#include "bundler/workspace/python_sources.hpp"

#include <set>
#include <string_view>
#include <tuple>

#include "bundler/io/files.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

/// A module, or a script that names Python in its first line.
bool is_python(const std::string& path, std::string_view bytes) {
  if (path.ends_with(".py")) return true;
  const std::string_view first = bytes.substr(0, bytes.find('\n'));
  return first.starts_with("#!") && first.find("python") != std::string_view::npos;
}

/// Files by their name, of those names only. Hidden and ignored folders are nobody's sources.
std::multimap<std::string, fs::path> files_of(const std::vector<fs::path>& places,
                                              const std::set<std::string>& names) {
  std::multimap<std::string, fs::path> found;
  const auto look_at = [&](const fs::path& file) {
    const std::string name = file.filename().string();
    if (names.contains(name)) found.emplace(name, file);
  };
  for (const fs::path& place : places) {
    std::error_code error;
    if (fs::is_regular_file(place, error)) look_at(place);
    if (!fs::is_directory(place, error)) continue;
    for (fs::recursive_directory_iterator it(place, error), end; !error && it != end;
         it.increment(error)) {
      std::error_code ignored;
      const bool is_hidden = it->path().filename().string().starts_with(".");
      // As for colcon, which marks what it has installed by this file.
      if (it->is_directory(ignored) &&
          (is_hidden || fs::exists(it->path() / "COLCON_IGNORE", ignored)))
        it.disable_recursion_pending();
      if (it->is_regular_file(ignored)) look_at(it->path());
    }
  }
  return found;
}

/// How many parts two paths have in common, from the end.
std::size_t common_end(const fs::path& a, const fs::path& b) {
  std::size_t count = 0;
  auto left = a.end();
  auto right = b.end();
  while (left != a.begin() && right != b.begin() && *--left == *--right) ++count;
  return count;
}

/// How good a file is as the source of another, and its path: the greatest is taken.
struct Candidate {
  std::size_t agrees = 0;
  std::string path;

  [[nodiscard]] bool is_better_than(const Candidate& other) const {
    if (other.path.empty()) return true;
    if (agrees != other.agrees) return agrees > other.agrees;
    return std::make_tuple(path.size(), path) < std::make_tuple(other.path.size(), other.path);
  }
};

}  // namespace

PythonSources python_sources(const PythonFiles& installed, const std::vector<fs::path>& places,
                             const fs::path& workspace) {
  std::set<std::string> names;
  for (const auto& [path, bytes] : installed) {
    if (!bytes.empty() && is_python(path, bytes)) names.insert(fs::path(path).filename().string());
  }
  const auto files = files_of(places, names);
  PythonSources sources;
  for (const auto& [path, bytes] : installed) {
    if (bytes.empty() || !is_python(path, bytes)) continue;
    Candidate best;
    const auto [first, last] = files.equal_range(fs::path(path).filename().string());
    for (auto it = first; it != last; ++it) {
      const Candidate one{.agrees = common_end(it->second, path),
                          .path = it->second.lexically_relative(workspace).generic_string()};
      if (one.path.empty() || !one.is_better_than(best)) continue;
      const auto text = read_file(it->second, kMostOfData);
      if (text && *text == bytes) best = one;
    }
    if (!best.path.empty()) sources.emplace(path, best.path);
  }
  return sources;
}

}  // namespace ros2wasm
