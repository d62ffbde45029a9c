// See shard_format.hpp.
#include "bundler/channel/shard_format.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "workspace_schema/record_rules.hpp"
#include "workspace_schema/secret_text.hpp"

namespace ros2wasm {
namespace {

constexpr std::uint64_t kLargestList = 512ULL << 20U;
constexpr std::uint64_t kLargestShard = 256ULL << 20U;

bool is_sha256(const std::string& text) {
  return text.size() == 64 && std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

/// As in RepodataIndex: a `.tar.bz2` is not needed where the same is there as a good `.conda`.
void add_records(const JsonValue& shard, const RecordPlace& place, SpecTable& specs,
                 RepoIndex& into) {
  std::set<std::string, std::less<>> removed;
  if (const JsonValue* list = shard.find("removed")) {
    for (const JsonValue& item : list->items()) {
      if (const std::string* name = item.string()) removed.insert(*name);
    }
  }
  std::set<std::string, std::less<>> stems;
  for (const char* key : {"packages.conda", "packages"}) {
    const JsonValue* packages = shard.find(key);
    if (packages == nullptr) continue;
    std::map<std::string_view, const JsonValue*> by_file;
    for (const auto& [file_name, record] : packages->members()) by_file[file_name] = &record;
    for (const auto& [view, json] : by_file) {
      const std::string file_name(view);
      if (removed.contains(file_name) || stems.contains(archive_stem(file_name))) continue;
      auto parsed = parse_record(*json, file_name, place, specs);
      if (auto* good = std::get_if<PackageRecord>(&parsed)) {
        stems.emplace(archive_stem(file_name));
        into.records.push_back(std::move(*good));
      } else {
        into.left_out.push_back({.channel = place.channel,
                                 .subdir = place.subdir,
                                 .file_name = file_name,
                                 .reason = std::move(std::get<std::string>(parsed))});
      }
    }
  }
}

}  // namespace

Outcome<ShardList> read_shard_list(std::string_view bytes, const std::string& url) {
  const auto packed = zstd_decompressed(bytes, kLargestList, url);
  if (!packed) return packed.errors();
  const auto list = parse_msgpack(*packed, url, "R2W0202");
  if (!list) return list.errors();
  const JsonValue* shards = list->find("shards");
  if (shards == nullptr || !shards->is_object()) return no_index(url, "it lists no shards");
  const JsonValue* version = list->find("version");
  if (version != nullptr && version->integer().value_or(1) != 1)
    return no_index(url, "its version is not 1");
  ShardList result;
  if (const JsonValue* info = list->find("info")) {
    result.base_url = without_secrets(info->text_of("base_url"));
    result.shards_base_url = without_secrets(info->text_of("shards_base_url"));
  }
  result.shards.reserve(shards->members().size());
  for (const auto& [name, sha256] : shards->members()) {
    const std::string* hex = sha256.string();
    if (hex == nullptr || !is_sha256(*hex))
      return no_index(url, "the shard of `" + name + "` has no sha256");
    result.shards.push_back({.name = name, .sha256 = *hex});
  }
  std::sort(result.shards.begin(), result.shards.end());
  return result;
}

Outcome<Done> read_shard(std::string_view bytes, const std::string& url, const RecordPlace& place,
                         SpecTable& specs, RepoIndex& into) {
  const auto packed = zstd_decompressed(bytes, kLargestShard, url);
  if (!packed) return packed.errors();
  const auto shard = parse_msgpack(*packed, url, "R2W0202");
  if (!shard) return shard.errors();
  add_records(*shard, place, specs, into);
  return Done{};
}

}  // namespace ros2wasm
