// See site_list.hpp.
#include "bundler/site/site_list.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

#include "bundler/io/sha256.hpp"
#include "bundler/site/site_file.hpp"
#include "bundler/site/site_path.hpp"
#include "workspace_schema/base/hash_text.hpp"
#include "workspace_schema/base/json_reader.hpp"

namespace ros2wasm {
namespace fs = std::filesystem;
namespace {

constexpr std::uint64_t kLargestFile = std::uint64_t{1} << 40U;

Diagnostic no_site(const std::string& shown, std::string why) {
  return Diagnostic{.code = "R2W0605",
                    .message = "`" + shown + "` is not the site.json of a site",
                    .why = {std::move(why)},
                    .fix = {}};
}

/// R2W0605.
Outcome<SiteStore> read_store(const JsonValue& json, const std::string& shown) {
  const JsonValue* store = json.find("store");
  if (store == nullptr) return SiteStore();
  SiteStore found{.objects = store->text_of("objects"), .scripts = store->text_of("scripts")};
  if (!is_store_address(found.objects) || !is_sha256_text(found.scripts))
    return no_site(shown, "its `store` is not a store of objects");
  return found;
}

/// R2W0605 they do not make up the file.
Outcome<std::vector<FilePart>> read_parts(const JsonValue& file, std::uint64_t whole,
                                          const std::string& shown) {
  std::vector<FilePart> parts;
  const JsonValue* list = file.find("parts");
  if (list == nullptr) return parts;
  std::uint64_t left = whole;
  for (const JsonValue& one : list->items()) {
    const JsonValue* size = one.find("size");
    const auto bytes = size == nullptr ? std::nullopt : size->unsigned_integer();
    FilePart part{.size = bytes.value_or(0), .sha256 = one.text_of("sha256")};
    if (!bytes || *bytes > left || !is_sha256_text(part.sha256)) {
      left = 1;
      break;
    }
    left -= part.size;
    parts.push_back(std::move(part));
  }
  if (left != 0 || parts.empty())
    return no_site(shown, "the parts of `" + file.text_of("path") + "` do not make it up");
  return parts;
}

/// Views, as there may be half a million.
std::optional<std::string> listed_twice(const std::vector<ListedFile>& files) {
  std::vector<std::string_view> paths;
  paths.reserve(files.size());
  for (const ListedFile& file : files) paths.emplace_back(file.path);
  std::sort(paths.begin(), paths.end());
  const auto twice = std::adjacent_find(paths.begin(), paths.end());
  if (twice == paths.end()) return std::nullopt;
  return std::string(*twice);
}

Kept kept_of(std::string_view word) {
  for (const Kept kept : {Kept::kObject, Kept::kScript}) {
    if (word == word_of(kept)) return kept;
  }
  return Kept::kBeside;
}

}  // namespace

std::vector<std::string> places_of(const ListedFile& file, const SiteList& list) {
  return site_places(file.path, file.sha256, file.kept, file.parts, list.store);
}

Outcome<SiteList> read_site_list(std::string_view site_json, const std::string& shown) {
  const auto json = parse_json(site_json, shown, "R2W0605");
  if (!json) return json.errors();
  SiteList list{.hash = sha256_hex(site_json),
                .generator = json->text_of("generator"),
                .carried_page_sha256 = json->text_of("carried_page_sha256"),
                .files = {}};
  auto store = read_store(*json, shown);
  if (!store) return std::move(store).errors();
  list.store = std::move(*store);
  if (!list.generator.starts_with(kSiteGenerator))
    return no_site(shown, "its `generator` is not ros2wasm");
  const JsonValue* files = json->find("files");
  if (files == nullptr || !files->is_array()) return no_site(shown, "it lists no files");
  list.files.reserve(files->items().size());
  for (const JsonValue& one : files->items()) {
    const JsonValue* size = one.find("size");
    const auto bytes = size == nullptr ? std::nullopt : size->unsigned_integer();
    ListedFile file{.path = one.text_of("path"),
                    .size = bytes.value_or(0),
                    .sha256 = one.text_of("sha256"),
                    .reason = one.text_of("reason")};
    if (!bytes || *bytes > kLargestFile || !is_sha256_text(file.sha256))
      return no_site(shown, "`" + file.path + "` has no size that can be, or no sha256");
    if (auto refusal = refuse_site_path(file.path)) return *refusal;
    auto parts = read_parts(one, file.size, shown);
    if (!parts) return std::move(parts).errors();
    file.parts = std::move(*parts);
    file.kept = kept_of(one.text_of("kept"));
    list.files.push_back(std::move(file));
  }
  if (const auto twice = listed_twice(list.files))
    return no_site(shown, "`" + *twice + "` appears twice");
  return list;
}

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kHex = "0123456789ABCDEF";
  constexpr std::string_view kPlain = "-._~/!$&'()*+,;=:@";
  std::string result;
  for (const char letter : path) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool alphanumeric = (byte >= '0' && byte <= '9') || (byte >= 'a' && byte <= 'z') ||
                              (byte >= 'A' && byte <= 'Z');
    if (alphanumeric || kPlain.find(letter) != std::string_view::npos) {
      result += letter;
    } else {
      result += {'%', kHex[byte >> 4U], kHex[byte & 15U]};
    }
  }
  return result;
}

std::string hash_list(const SiteList& list) {
  std::vector<PlannedFile> files{
      {.path = kSiteJsonName, .reason = {}, .bytes = {}, .sha256 = list.hash}};
  for (const ListedFile& file : list.files) {
    const std::vector<std::string> places = places_of(file, list);
    for (std::size_t i = 0; i < places.size(); ++i) {
      files.push_back({.path = places[i],
                       .reason = {},
                       .bytes = {},
                       .sha256 = file.parts.empty() ? file.sha256 : file.parts[i].sha256});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const PlannedFile& a, const PlannedFile& b) { return a.path < b.path; });
  return hash_list(files);
}

PlaceHashes places_of_lab(const SiteList& list, const std::string& name) {
  PlaceHashes files{{name + "/" + kSiteJsonName, list.hash}};
  for (const ListedFile& one : list.files) {
    const std::vector<std::string> places = places_of(one, list);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const fs::path place = fs::path(name) / places[i];
      files[place.lexically_normal().generic_string()] =
          one.parts.empty() ? one.sha256 : one.parts[i].sha256;
    }
  }
  return files;
}

std::string hash_list(const PlaceHashes& files) {
  std::string text;
  for (const auto& [path, sha256] : files) text += sha256 + "  " + path + "\n";
  return text;
}

}  // namespace ros2wasm
