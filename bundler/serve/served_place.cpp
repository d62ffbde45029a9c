// See served_place.hpp.
#include "bundler/serve/served_place.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>

#include "bundler/emit/folder_output.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "bundler/site/own_site.hpp"
#include "bundler/site/site_list.hpp"
#include "bundler/site/site_place.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

Descriptor owned(int fd) {
  if (fd < 0) return nullptr;
  return {new int(fd), [](const int* held) {
            close(*held);
            delete held;
          }};
}

/// Null for what is not a folder, and for a link.
Descriptor open_folder(int parent, const std::string& name) {
  return owned(openat(parent, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

Descriptor open_folder(const fs::path& real) {
  return open_folder(AT_FDCWD, real.string());
}

/// Where an open file is, by the kernel; empty when it was removed.
fs::path place_of(int fd) {
  std::error_code error;
  const fs::path own = "/proc/self/fd/" + std::to_string(fd);
  fs::path place = fs::read_symlink(own, error);
  struct stat named {};
  struct stat opened {};
  const bool is_there = !error && stat(place.c_str(), &named) == 0 && fstat(fd, &opened) == 0 &&
                        named.st_ino == opened.st_ino && named.st_dev == opened.st_dev;
  return is_there ? place : fs::path();
}

/// The file is opened first and looked at then, so that nobody can put another in its place in
/// between.
Found opened_within(const Descriptor& root, const std::string& below, int flags) {
  Descriptor file = owned(openat(*root, below.empty() ? "." : below.c_str(),
                                 O_RDONLY | O_CLOEXEC | O_NONBLOCK | flags));
  if (!file) return {};
  struct stat status {};
  if (fstat(*file, &status) != 0) return {};
  const bool is_folder = S_ISDIR(status.st_mode);
  if (!is_folder && !S_ISREG(status.st_mode)) return {};
  const fs::path real = place_of(*file);
  const fs::path from_root = real.lexically_relative(place_of(*root));
  if (real.empty() || from_root.empty() || *from_root.begin() == "..") return {};
  return {.kind = is_folder ? Lookup::kFolder : Lookup::kFile,
          .file = std::move(file),
          .path = real,
          .is_page = false,
          .root = root,
          .below = below};
}

Found find_within(const Descriptor& root, std::string_view path) {
  if (!root) return {};
  Found found = opened_within(root, std::string(path), 0);
  // A pack may have put a new file in the place of the one that was opened.
  return found.kind == Lookup::kNothing ? opened_within(root, std::string(path), 0) : found;
}

/// The name of a site's earlier pack is that of the site, with its sha256; the bytes prove it.
bool is_earlier_pack(const Descriptor& folder, const std::string& own_name,
                     const std::string& site_name) {
  const Found json = find_within(folder, kSiteJsonName);
  if (json.kind != Lookup::kFile) return false;
  const auto text = read_file("/proc/self/fd/" + std::to_string(*json.file), kMostOfSiteJson);
  return text && own_name == earlier_folder(site_name, sha256_hex(*text));
}

/// The start page, or that of a lab of a course. Other documents were brought along by a lab.
bool is_page_of(const fs::path& folder, std::string_view below) {
  constexpr std::string_view kPage = "index.html";
  if (below == kPage) return true;
  const std::size_t slash = below.find('/');
  return slash != std::string_view::npos && below.substr(slash + 1) == kPage &&
         is_course_of_ours(folder);
}

Diagnostic no_store(const fs::path& site, const std::string& objects, const fs::path& store) {
  std::error_code error;
  const bool is_there = fs::is_directory(store, error);
  return Diagnostic{.code = "R2W0613",
                    .severity = Severity::kWarning,
                    .message = "files of `" + site.string() + "` are not served",
                    .why = {"its site.json says that they are in the store `" + objects + "`",
                            is_there ? "that folder has no " + std::string(kStoreMarker) +
                                           " of ros2wasm, and other files than those of a store"
                                     : "there is no such folder"},
                    .fix = {"pack the site again with `--store`, or copy its store beside it"}};
}

}  // namespace

ServedPlace served_place(const fs::path& site) {
  std::error_code error;
  const fs::path real = fs::canonical(site, error);
  const fs::path& folder = error ? site : real;
  ServedPlace place{.folder = folder,
                    .parent = open_folder(folder.parent_path()),
                    .address = {},
                    .store = {},
                    .store_address = {}};
  const auto text = read_file(site / kSiteJsonName, kMostOfSiteJson);
  const auto list = text ? read_site_list(*text, kSiteJsonName) : Outcome<SiteList>(SiteList());
  if (!list || list->store.objects.empty()) return place;
  if (error) return place;
  const fs::path named = (real / list->store.objects).lexically_normal();
  const fs::path store = fs::canonical(named, error);
  if (error || !fs::is_directory(store, error) || !is_store_of_ours(store)) {
    place.warning = no_store(site, list->store.objects, named);
    return place;
  }
  // Addresses have as many folders as the way from the site to its store needs.
  fs::path root = real;
  constexpr std::string_view kUp = "../";
  for (std::string_view left = list->store.objects; left.starts_with(kUp);
       left.remove_prefix(kUp.size()))
    root = root.parent_path();
  place.address = real.lexically_relative(root).generic_string() + "/";
  place.store = store;
  place.store_folder = open_folder(store);
  place.store_address = named.lexically_relative(root).generic_string();
  return place;
}

Found find_served(const ServedPlace& place, const std::string& path) {
  if (!place.store.empty() && path.starts_with(place.store_address)) {
    const std::string_view below = std::string_view(path).substr(place.store_address.size());
    return is_store_path(below) ? find_within(place.store_folder, below) : Found{};
  }
  const std::string name = place.folder.filename().string();
  const auto open_beside = [&](const std::string& one) {
    if (!place.parent) return Descriptor();
    return one.empty() ? place.parent : open_folder(*place.parent, one);
  };
  if (path.starts_with(place.address)) {
    const std::string_view below = std::string_view(path).substr(place.address.size());
    Found found = find_within(open_beside(name), below);
    // A course has no store above it.
    found.is_page =
        below == "index.html" || (place.address.empty() && is_page_of(place.folder, below));
    return found;
  }
  if (path + "/" == place.address) return find_within(open_beside(name), "");
  // The remaining addresses are earlier packs beside the site.
  const std::string beside = place.address.substr(0, place.address.size() - name.size() - 1);
  if (!path.starts_with(beside)) return {};
  const std::string top = path.substr(beside.size(), path.find('/', beside.size()) - beside.size());
  if (!top.starts_with(name + "@")) return {};
  const Descriptor pack = open_beside(top);
  if (!pack || !is_earlier_pack(pack, top, name)) return {};
  const std::size_t at = std::min(beside.size() + top.size() + 1, path.size());
  const std::string_view below = std::string_view(path).substr(at);
  Found found = find_within(pack, below);
  found.is_page = below == "index.html";
  return found;
}

Found form_beside(const Found& found, std::string_view ending) {
  Found form = opened_within(found.root, found.below + std::string(ending), O_NOFOLLOW);
  return form.kind == Lookup::kFile ? form : Found{};
}

}  // namespace ros2wasm
