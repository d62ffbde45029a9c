// See link_rules.hpp.
#include "bundler/archive/link_rules.hpp"

#include <algorithm>
#include <vector>

namespace ros2wasm {
namespace {

std::vector<std::string_view> parts_of(std::string_view path) {
  std::vector<std::string_view> parts;
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    const std::string_view part = path.substr(0, slash);
    if (!part.empty() && part != ".") parts.push_back(part);
    if (slash == std::string_view::npos) break;
    path.remove_prefix(slash + 1);
  }
  return parts;
}

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
  });
}

}  // namespace

bool link_ends_inside(const std::filesystem::path& root, const std::string& path) {
  std::error_code error;
  const std::filesystem::path top = std::filesystem::canonical(root, error);
  if (error) return false;
  const std::filesystem::path end = std::filesystem::weakly_canonical(top / path, error);
  // A circle of links leads nowhere.
  if (error) return error == std::errc::too_many_symbolic_link_levels;
  const std::filesystem::path from_top = end.lexically_relative(top);
  return !from_top.empty() && *from_top.begin() != "..";
}

std::optional<std::string> link_script_package(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const std::string_view folder = path.substr(0, slash);
  std::string_view file = path.substr(slash + 1);
  const bool programs = folder == "bin" || folder == "python-scripts" || folder == "Scripts";
  if (!programs || !file.starts_with('.')) return std::nullopt;
  file.remove_prefix(1);
  for (const std::string_view ending : {".sh", ".bat"}) {
    if (!file.ends_with(ending)) continue;
    file.remove_suffix(ending.size());
    for (const std::string_view action : {"-pre-link", "-post-link", "-pre-unlink"}) {
      if (file.ends_with(action) && file.size() > action.size())
        return std::string(file.substr(0, file.size() - action.size()));
    }
    break;
  }
  return std::nullopt;
}

std::optional<std::string> safe_member_path(std::string_view name) {
  if (name.empty() || name.front() == '/' || has_control_character(name)) return std::nullopt;
  std::string clean;
  for (const std::string_view part : parts_of(name)) {
    if (part == "..") return std::nullopt;
    if (!clean.empty()) clean += '/';
    clean += part;
  }
  if (clean.empty()) return std::nullopt;
  return clean;
}

bool link_stays_inside(std::string_view path, std::string_view target) {
  if (target.empty() || target.front() == '/' || has_control_character(target)) return false;
  std::size_t depth = parts_of(path).size();
  if (depth == 0) return false;
  --depth;  // the link's own folder
  bool downwards = false;
  for (const std::string_view part : parts_of(target)) {
    if (part != "..") {
      downwards = true;
      continue;
    }
    // After a name that may itself be a link, nobody knows what `..` means.
    if (downwards || depth == 0) return false;
    --depth;
  }
  return true;
}

}  // namespace ros2wasm
