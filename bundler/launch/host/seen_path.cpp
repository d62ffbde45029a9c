// See seen_path.hpp.
#include "bundler/launch/host/seen_path.hpp"

#include <algorithm>
#include <filesystem>

#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr const char* kNone = "none";

/// The real path, if one is shown.
std::optional<fs::path> shown_path(const LaunchFolder& folder, const fs::path& below) {
  std::error_code error;
  const fs::path root = fs::canonical(folder.from, error);
  if (error) return std::nullopt;
  fs::path real = fs::canonical(root / below, error);
  if (error) return std::nullopt;
  const fs::path inside = real.lexically_relative(root);
  if (inside == ".") return real;
  const bool is_open = std::none_of(inside.begin(), inside.end(), [](const fs::path& part) {
    return part.string().starts_with('.');  // hidden, or `..`
  });
  return is_open && !inside.empty() ? std::optional(std::move(real)) : std::nullopt;
}

std::string names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::string name = at->path().filename().string();
    if (!name.starts_with('.')) names.push_back(std::move(name));
  }
  // JavaScript sorts by UTF-16: where that is another order, the folder counts as changed.
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += name + "\n";
  return "names " + sha256_hex(text);
}

/// `with_content`: also what is in a file.
std::string state_of(const fs::path& real, bool with_content) {
  std::error_code error;
  const auto status = fs::status(real, error);
  if (fs::is_directory(status)) return "directory";
  if (!fs::is_regular_file(status)) return kNone;
  if (!with_content) return "file " + std::to_string(fs::file_size(real, error));
  const auto hashes = hash_file(real);
  if (!hashes) return kNone;
  return "file " + std::to_string(hashes->size) + " " + hashes->sha256;
}

}  // namespace

bool is_still(const std::vector<LaunchFolder>& folders, const std::string& path,
              std::string_view state) {
  const bool is_listing = path.ends_with('/');
  const fs::path plain = is_listing ? path.substr(0, path.size() - 1) : path;
  for (const LaunchFolder& folder : folders) {
    const fs::path below = plain.lexically_relative(folder.at);
    if (below.empty() || *below.begin() == "..") continue;
    const auto real = shown_path(folder, below);
    if (!real) return state == kNone;
    if (is_listing) return names_in(*real) == state;
    const bool with_content = state.starts_with("file ") && state.find(' ', 5) != state.npos;
    return state_of(*real, with_content) == state;
  }
  return false;
}

}  // namespace ros2wasm
