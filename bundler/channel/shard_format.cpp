// See shard_format.hpp.
#include "bundler/channel/shard_format.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/in_order.hpp"
#include "bundler/channel/msgpack_reader.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "workspace_schema/base/hash_text.hpp"
#include "workspace_schema/base/secret_text.hpp"
#include "workspace_schema/base/text_pattern.hpp"
#include "workspace_schema/conda/record_rules.hpp"

namespace ros2wasm {
namespace {

constexpr std::uint64_t kLargestList = 512ULL << 20U;
constexpr std::uint64_t kLargestShard = 256ULL << 20U;
constexpr std::uint32_t kMostArchives = 1'000'000;  ///< of a shard, which is of one name
constexpr std::uint32_t kMostTexts = 100'000;       ///< of a list in a record

/// As its bytes, or as a text.
bool is_sha256(std::string_view hash) {
  return hash.size() == 32 || is_sha256_text(hash);
}

Diagnostic no_msgpack(const std::string& url) {
  return Diagnostic{
      .code = "R2W0202",
      .kind = FailureKind::kEnvironment,
      .message = "`" + url + "` is not valid MessagePack",
      .why = {
          "it is damaged, or has something else where a sharded index has maps, texts and hashes"}};
}

/// Reads a map: `take(key)` reads each value. False when something else is there, or `take` says
/// so.
template <typename Take>
bool each_member(MsgpackReader& reader, const Take& take) {
  const auto pairs = reader.map();
  for (std::uint32_t i = 0; pairs && i < *pairs; ++i) {
    const auto key = reader.key();
    if (!key || !take(*key)) return false;
  }
  return pairs.has_value();
}

struct RawEntry {
  std::string_view file_name;
  std::string_view bytes;  ///< of its record
};
using RawRecords = std::vector<RawEntry>;

struct RawShard {
  RawRecords conda;
  RawRecords tar;
  std::set<std::string_view> removed;
};

std::optional<RawShard> raw_shard(std::string_view bytes) {
  RawShard shard;
  MsgpackReader reader(bytes);
  std::uint32_t archives = 0;
  const auto read_records = [&](RawRecords& into) {
    return each_member(reader, [&](std::string_view file_name) {
      const auto record = reader.skipped();
      if (record) into.push_back({.file_name = file_name, .bytes = *record});
      return record && ++archives <= kMostArchives;
    });
  };
  const auto read_removed = [&] {
    const auto count = reader.array();
    for (std::uint32_t i = 0; count && i < *count; ++i) {
      const auto file_name = reader.key();
      if (!file_name || ++archives > kMostArchives) return false;
      shard.removed.insert(*file_name);
    }
    return count.has_value();
  };
  const bool whole = each_member(reader, [&](std::string_view key) {
    if (key == "packages") return read_records(shard.tar);
    if (key == "packages.conda") return read_records(shard.conda);
    if (key == "removed") return read_removed();
    return reader.skipped().has_value();
  });
  if (!whole || !reader.at_end()) return std::nullopt;
  for (RawRecords* records : {&shard.conda, &shard.tar})
    put_in_order(*records, [](const RawEntry& entry) { return entry.file_name; });
  return shard;
}

/// A list of texts; nothing when it is something else, which may not be read further then.
std::optional<Texts> text_list(MsgpackReader& reader) {
  const auto count = reader.array();
  if (!count || *count > kMostTexts) return std::nullopt;
  Texts texts;
  for (std::uint32_t i = 0; i < *count; ++i) {
    const auto text = reader.key();
    if (!text) return std::nullopt;
    texts.push_back(*text);
  }
  return texts;
}

bool read_member(MsgpackReader& reader, RecordMember member, RawMember& into) {
  const MsgpackReader before = reader;
  if (const auto text = reader.key()) {
    into = *text;
    return true;
  }
  reader = before;
  if (member == RecordMember::kSha256 || member == RecordMember::kMd5) {
    if (const auto bytes = reader.content()) {
      into = HashBytes{*bytes};
      return true;
    }
  } else if (auto texts = text_list(reader)) {
    into = std::move(*texts);
    return true;
  }
  reader = before;
  auto value = reader.value();
  if (value) into = std::move(*value);
  return value.has_value();
}

/// Nothing when it is not a map, or too deep.
std::optional<RawRecord> raw_record(std::string_view bytes) {
  RawRecord record;
  MsgpackReader reader(bytes);
  const bool whole = each_member(reader, [&](std::string_view key) {
    const auto member = record_member(key);
    return member ? read_member(reader, *member, record[*member]) : reader.skipped().has_value();
  });
  return whole ? std::optional(std::move(record)) : std::nullopt;
}

/// As in RepodataIndex: a `.tar.bz2` is not needed where the same is there as a good `.conda`.
void add_records(const RawShard& shard, const RecordPlace& place, SpecTable& specs,
                 RepoIndex& into) {
  std::set<std::string, std::less<>> stems;
  for (const RawRecords* records : {&shard.conda, &shard.tar}) {
    for (const auto& [view, bytes] : *records) {
      const std::string file_name(view);
      if (shard.removed.contains(file_name) || stems.contains(archive_stem(file_name))) continue;
      const auto raw = raw_record(bytes);
      auto parsed = raw ? parse_record(*raw, file_name, place, specs)
                        : std::variant<PackageRecord, std::string>("it is not a map of texts");
      if (auto* good = std::get_if<PackageRecord>(&parsed)) {
        if (!shard.tar.empty()) stems.emplace(archive_stem(file_name));
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

std::string ShardHash::hex() const {
  return bytes.size() == 32 ? hex_text(bytes) : std::string(bytes);
}

Outcome<ShardList> read_shard_list(std::string_view bytes, const std::string& url) {
  auto text = zstd_decompressed(bytes, kLargestList, url);
  if (!text) return std::move(text).errors();
  ShardList list;
  list.listed = std::make_unique<std::string>(std::move(*text));
  MsgpackReader reader(*list.listed);
  bool listed = false;
  std::optional<std::string_view> without_hash;
  std::int64_t version = 1;
  const bool whole = each_member(reader, [&](std::string_view key) {
    if (key == "shards") {
      listed = true;
      list.shards.clear();
      return each_member(reader, [&](std::string_view name) {
        const auto hash = reader.content();
        if (!hash) return false;
        if (!is_sha256(*hash)) {  // asked at once: a shard takes more memory than such a pair
          without_hash = name;
          return false;
        }
        list.shards.insert_or_assign(name, ShardHash{*hash});  // a repeated name keeps the last
        return true;
      });
    }
    if (key != "info" && key != "version") return reader.skipped().has_value();
    const auto value = reader.value();
    if (!value) return false;
    if (key == "version") {
      version = value->integer().value_or(1);
    } else {
      list.base_url = without_secrets(value->text_of("base_url"));
      list.shards_base_url = without_secrets(value->text_of("shards_base_url"));
    }
    return true;
  });
  if (without_hash)
    return no_index(url, "the shard of `" + std::string(*without_hash) + "` has no sha256");
  if (!whole || !reader.at_end()) return no_msgpack(url);
  if (!listed) return no_index(url, "it lists no shards");
  if (version != 1) return no_index(url, "its version is not 1");
  return list;
}

Outcome<Done> read_shard(std::string_view bytes, const std::string& url, const RecordPlace& place,
                         SpecTable& specs, RepoIndex& into) {
  const auto text = zstd_decompressed(bytes, kLargestShard, url);
  if (!text) return text.errors();
  const auto shard = raw_shard(*text);
  if (!shard) return no_msgpack(url);
  add_records(*shard, place, specs, into);
  return Done{};
}

}  // namespace ros2wasm
