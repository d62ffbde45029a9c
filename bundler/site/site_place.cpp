// See site_place.hpp.
#include "bundler/site/site_place.hpp"

#include <algorithm>

namespace ros2wasm {
namespace {

constexpr std::size_t kMostFolders = 8;
constexpr std::size_t kMostOfEnding = 8;
constexpr std::size_t kHexOfSha256 = 64;

bool is_small(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= '0' && letter <= '9');
}

bool is_hex_digit(char letter) {
  return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
}

bool is_alphanumeric(char letter) {
  return is_small(letter) || (letter >= 'A' && letter <= 'Z');
}

bool is_plain_name(std::string_view name) {
  return !name.empty() && name.front() != '.' && std::all_of(name.begin(), name.end(), [](char c) {
    return is_small(c) || (c >= 'A' && c <= 'Z') || c == '_' || c == '-' || c == '.';
  });
}

/// `.wasm`: hosts tell by it what they send.
std::string ending(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string::npos || dot == 0 || path[dot - 1] == '/') return {};
  const std::string after = path.substr(dot + 1);
  const bool good = !after.empty() && after.size() <= kMostOfEnding &&
                    std::all_of(after.begin(), after.end(), is_small);
  return good ? "." + after : "";
}

}  // namespace

bool is_store_address(std::string_view address) {
  constexpr std::string_view kUp = "../";
  std::size_t ups = 0;
  for (; address.starts_with(kUp); ++ups) address.remove_prefix(kUp.size());
  std::size_t folders = 0;
  for (; !address.empty(); ++folders) {
    const std::size_t slash = address.find('/');
    if (slash == std::string_view::npos || !is_plain_name(address.substr(0, slash))) return false;
    address.remove_prefix(slash + 1);
  }
  return ups > 0 && ups <= kMostFolders && folders > 0 && folders <= kMostFolders;
}

std::vector<std::string> site_places(const std::string& path, const std::string& sha256, Kept kept,
                                     const std::vector<FilePart>& parts, const SiteStore& store) {
  const bool stored = !store.objects.empty();
  std::vector<std::string> places;
  for (const FilePart& part : parts) {
    places.push_back(stored ? store.objects + part.sha256 + ".part"
                            : path + ".part" + std::to_string(places.size() + 1));
  }
  if (!places.empty()) return places;
  if (!stored || kept == Kept::kBeside) return {path};
  if (kept == Kept::kScript) return {store.objects + store.scripts + "/" + path};
  return {store.objects + sha256 + ending(path)};
}

bool is_store_name(std::string_view name) {
  constexpr std::size_t kMostEndings = 3;  // the last one is random while the file is written
  if (name.size() < kHexOfSha256 ||
      !std::all_of(name.begin(), name.begin() + kHexOfSha256, is_hex_digit))
    return false;
  name.remove_prefix(kHexOfSha256);
  for (std::size_t i = 0; !name.empty(); ++i) {
    const std::size_t end = std::min(name.find('.', 1), name.size());
    const std::string_view one = name.substr(0, end);
    if (i == kMostEndings || one.front() != '.' || one.size() < 2 ||
        one.size() > kMostOfEnding + 1 || !std::all_of(one.begin() + 1, one.end(), is_alphanumeric))
      return false;
    name.remove_prefix(end);
  }
  return true;
}

bool is_store_path(std::string_view path) {
  const std::size_t slash = path.find('/');
  if (slash == std::string_view::npos) return is_store_name(path);
  return slash == kHexOfSha256 && is_store_name(path.substr(0, slash)) && slash + 1 < path.size();
}

std::string_view word_of(Kept kept) {
  switch (kept) {
    case Kept::kBeside:
      return {};
    case Kept::kObject:
      return "object";
    case Kept::kScript:
      return "script";
  }
  return {};
}

}  // namespace ros2wasm
