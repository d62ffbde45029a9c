// See cached_work.hpp.
#include "bundler/build/cached_work.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include "bundler/build/source_tree.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kList = "ros2wasm-sources";  // sha256 and path, a line each

/// When the newest file below a folder was made; nothing when there is none.
std::optional<fs::file_time_type> newest_below(const fs::path& folder) {
  std::optional<fs::file_time_type> newest;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    std::error_code gone;
    if (!it->is_regular_file(gone)) continue;
    const auto time = it->last_write_time(gone);
    if (!gone && (!newest || *newest < time)) newest = time;
  }
  return newest;
}

std::set<std::string> lines_of(const std::string& text) {
  std::set<std::string> result;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) result.insert(line);
  return result;
}

/// Is it a path to something below a folder?
bool is_within(const fs::path& path) {
  return path.is_relative() && std::find(path.begin(), path.end(), "..") == path.end();
}

}  // namespace

Outcome<Done> forget_what_times_hide(const fs::path& work, const fs::path& sources,
                                     const fs::path& workspace) {
  const auto tree = source_tree(sources, workspace);
  if (!tree) return tree.errors();
  const auto before = read_file(work / kList, kMostOfList);
  const std::set<std::string> known = before ? lines_of(*before) : std::set<std::string>();
  const auto newest = newest_below(work);
  bool is_hidden = false;
  std::string list;
  for (const SourceEntry& entry : *tree) {
    if (entry.is_folder) continue;
    const fs::path file = sources / entry.path;
    const auto hashes = hash_file(file);
    if (!hashes) return hashes.errors();
    const std::string line = hashes->sha256 + " " + entry.path;
    list += line + "\n";
    if (!newest || known.contains(line)) continue;
    std::error_code error;
    const auto time = fs::last_write_time(file, error);
    is_hidden = is_hidden || error || time <= *newest;
  }
  if (is_hidden) {
    if (auto removed = remove_tree(work); !removed) return removed;
    if (auto made = make_directories(work); !made) return made;
  }
  return write_file(work / kList, list);
}

Outcome<std::vector<SeenSource>> seen_sources(const fs::path& work) {
  const auto list = read_file(work / kList, kMostOfList);
  if (!list) return list.errors();
  std::vector<SeenSource> result;
  std::istringstream lines(*list);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    // A folder may have a line break in its name: a row must not lead out of the package.
    if (space != std::string::npos && is_within(line.substr(space + 1)))
      result.push_back({.sha256 = line.substr(0, space), .path = line.substr(space + 1)});
  }
  return result;
}

}  // namespace ros2wasm
