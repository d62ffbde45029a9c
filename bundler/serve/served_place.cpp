// See served_place.hpp.
#include "bundler/serve/served_place.hpp"

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

Found find_within(const fs::path& folder, std::string_view path) {
  std::error_code error;
  const auto real = path_within(folder, path.empty() ? folder : folder / path);
  if (!real) return {};
  if (fs::is_directory(*real, error)) return {.kind = Lookup::kFolder, .path = *real};
  if (fs::is_regular_file(*real, error)) return {.kind = Lookup::kFile, .path = *real};
  return {};
}

/// The name of a site's earlier pack is that of the site, with its sha256; the bytes prove it.
bool is_earlier_pack(const fs::path& folder, const std::string& name) {
  const auto json = path_within(folder, folder / kSiteJsonName);
  std::error_code error;
  if (fs::symlink_status(folder, error).type() != fs::file_type::directory) return false;
  if (!json || !fs::is_regular_file(*json, error)) return false;
  const auto text = read_file(*json, kMostOfSiteJson);
  return text && folder.filename() == earlier_folder(name, sha256_hex(*text));
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
  ServedPlace place{.folder = site, .address = {}, .store = {}, .store_address = {}};
  const auto text = read_file(site / kSiteJsonName, kMostOfSiteJson);
  const auto list = text ? read_site_list(*text, kSiteJsonName) : Outcome<SiteList>(SiteList());
  if (!list || list->store.objects.empty()) return place;
  std::error_code error;
  const fs::path real = fs::canonical(site, error);
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
  return {.folder = real,
          .address = real.lexically_relative(root).generic_string() + "/",
          .store = store,
          .store_address = named.lexically_relative(root).generic_string()};
}

Found find_served(const ServedPlace& place, const std::string& path) {
  if (!place.store.empty() && path.starts_with(place.store_address)) {
    const std::string_view below = std::string_view(path).substr(place.store_address.size());
    return is_store_path(below) ? find_within(place.store, below) : Found{};
  }
  if (path.starts_with(place.address))
    return find_within(place.folder, std::string_view(path).substr(place.address.size()));
  if (path + "/" == place.address) return find_within(place.folder, "");
  // The remaining addresses are earlier packs beside the site.
  const std::string name = place.folder.filename().string();
  const std::string beside = place.address.substr(0, place.address.size() - name.size() - 1);
  if (!path.starts_with(beside)) return {};
  const std::string top = path.substr(beside.size(), path.find('/', beside.size()) - beside.size());
  const fs::path pack = place.folder.parent_path() / top;
  if (!top.starts_with(name + "@") || !is_earlier_pack(pack, name)) return {};
  const std::size_t below = std::min(beside.size() + top.size() + 1, path.size());
  return find_within(pack, std::string_view(path).substr(below));
}

}  // namespace ros2wasm
