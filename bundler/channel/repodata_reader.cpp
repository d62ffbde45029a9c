// parse_repodata() of channel_index.hpp: one repodata.json as records. Pure.
#include <algorithm>
#include <set>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/record_rules.hpp"
#include "bundler/channel/repodata_record.hpp"
#include "bundler/channel/transport.hpp"

namespace ros2wasm {
namespace {

/// What a file name is put behind: the folder of the index itself, or `info.base_url` (CEP 15),
/// which may be relative to that folder.
std::string archive_base_url(const JsonValue& json, const std::string& channel,
                             const std::string& subdir) {
  std::string here = channel_base_url(channel) + "/" + subdir;
  const JsonValue* info = json.find("info");
  std::string base = info == nullptr ? std::string() : info->text_of("base_url");
  while (base.ends_with('/')) base.pop_back();
  if (base.empty() || base == ".") return here;
  const bool absolute = base.find("://") != std::string::npos || base.starts_with('/');
  return absolute ? base : here + "/" + base;
}

std::set<std::string, std::less<>> removed_names(const JsonValue& json) {
  std::set<std::string, std::less<>> names;
  if (const JsonValue* removed = json.find("removed")) {
    for (const JsonValue& item : removed->items()) {
      if (const std::string* name = item.string()) names.insert(*name);
    }
  }
  return names;
}

}  // namespace

Outcome<RepoIndex> parse_repodata(std::string_view text, const std::string& channel,
                                  const std::string& subdir) {
  const std::string name = channel_base_url(channel) + "/" + subdir + "/repodata.json";
  RepoIndex index;
  index.channels.push_back(channel);
  if (text.empty()) return index;  // CEP 26: an empty file is an empty channel
  const auto json = parse_json(text, name, "R2W0202");
  if (!json) return json.errors();
  if (!json->is_object()) {
    return Diagnostic{.code = "R2W0202",
                      .kind = FailureKind::kEnvironment,
                      .message = "`" + name + "` is no index of a channel",
                      .why = {"it is not a JSON object"}};
  }
  const RecordPlace place{
      .channel = channel, .subdir = subdir, .base_url = archive_base_url(*json, channel, subdir)};
  const auto removed = removed_names(*json);
  std::set<std::string, std::less<>>
      stems;  // of what is there as .conda: its .tar.bz2 twin is not needed
  for (const std::string_view key :
       {std::string_view("packages.conda"), std::string_view("packages")}) {
    const JsonValue* packages = json->find(key);
    if (packages == nullptr) continue;
    for (const auto& [file_name, member] : packages->members()) {
      if (removed.contains(file_name)) continue;
      const std::string stem(archive_stem(file_name));
      if (stems.contains(stem)) continue;
      auto parsed = parse_record(member, file_name, place);
      if (auto* record = std::get_if<PackageRecord>(&parsed)) {
        if (key == "packages.conda") stems.insert(stem);
        index.records.push_back(std::move(*record));
      } else {
        index.left_out.push_back({.channel = channel,
                                  .subdir = subdir,
                                  .file_name = file_name,
                                  .reason = std::get<std::string>(parsed)});
      }
    }
  }
  std::sort(
      index.records.begin(), index.records.end(),
      [](const PackageRecord& a, const PackageRecord& b) { return a.file_name < b.file_name; });
  std::sort(
      index.left_out.begin(), index.left_out.end(),
      [](const LeftOutRecord& a, const LeftOutRecord& b) { return a.file_name < b.file_name; });
  return index;
}

}  // namespace ros2wasm
