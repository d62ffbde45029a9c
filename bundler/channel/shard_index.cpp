// See shard_index.hpp.
#include "bundler/channel/shard_index.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/channel_address.hpp"
#include "bundler/channel/transport.hpp"
#include "bundler/channel/verified_files.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
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

struct Shard {
  std::string name;  ///< of the package
  std::string url;
  std::string sha256;
};

class ShardIndex : public SubdirIndex {
 public:
  ShardIndex(RepodataSource source, const ChannelRoots& roots)
      : source_(std::move(source)), roots_(roots) {}

  [[nodiscard]] Outcome<Done> open() {
    const auto bytes = read_file(source_.file);
    if (!bytes) return bytes.errors();
    const auto packed = zstd_decompressed(*bytes, kLargestList, source_.url);
    if (!packed) return packed.errors();
    const auto list = parse_msgpack(*packed, source_.url, "R2W0202");
    if (!list) return list.errors();
    const JsonValue* shards = list->find("shards");
    if (shards == nullptr || !shards->is_object())
      return no_index(source_.url, "it lists no shards");
    const JsonValue* version = list->find("version");
    if (version != nullptr && version->integer().value_or(1) != 1)
      return no_index(source_.url, "its version is not 1");
    if (const JsonValue* info = list->find("info")) {
      shards_base_ =
          with_base_url(without_secrets(info->text_of("shards_base_url")), source_.place.base_url);
      source_.place.base_url =
          with_base_url(without_secrets(info->text_of("base_url")), source_.place.base_url);
    } else {
      shards_base_ = source_.place.base_url;
    }
    for (const auto& [name, sha256] : shards->members()) {
      const std::string* hex = sha256.string();
      if (hex == nullptr || !is_sha256(*hex))
        return no_index(source_.url, "the shard of `" + name + "` has no sha256");
      shards_.emplace_back(name, *hex);
    }
    std::sort(shards_.begin(), shards_.end());
    for (const auto& [name, sha256] : shards_) names_.emplace_back(name);
    return Done{};
  }

  [[nodiscard]] std::span<const std::string_view> names() const override { return names_; }

  [[nodiscard]] Outcome<Done> read(std::span<const std::string> names, SpecTable& specs,
                                   RepoIndex& into, const Cancellation& cancellation) override {
    std::vector<Shard> wanted;
    for (const std::string& name : names) {
      const auto found = std::lower_bound(names_.begin(), names_.end(), name);
      if (found == names_.end() || *found != name) continue;
      const std::string& sha256 = shards_[static_cast<std::size_t>(found - names_.begin())].second;
      wanted.push_back(
          {.name = name, .url = shards_base_ + "/" + sha256 + ".msgpack.zst", .sha256 = sha256});
    }
    auto bytes = bring(wanted, cancellation);
    if (!bytes) return std::move(bytes).errors();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (cancellation.requested()) return interrupted();
      const auto packed = zstd_decompressed((*bytes)[i], kLargestShard, wanted[i].url);
      if (!packed) return packed.errors();
      const auto shard = parse_msgpack(*packed, wanted[i].url, "R2W0202");
      if (!shard) return shard.errors();
      add(*shard, specs, into);
    }
    return Done{};
  }

 private:
  /// The bytes of these shards, each with the right sha256.
  Outcome<std::vector<std::string>> bring(const std::vector<Shard>& wanted,
                                          const Cancellation& cancellation) {
    std::vector<std::string> bytes(wanted.size());
    Diagnostics errors;
    std::vector<WantedFile> files;
    const bool network = is_network_url(shards_base_);
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const Shard& shard = wanted[i];
      files.push_back({.what = "the part of an index that has `" + shard.name + "`",
                       .url = shard.url,
                       .place = roots_.cache / "shards" / shard.sha256.substr(0, 2) /
                                (shard.sha256 + ".msgpack.zst"),
                       .size = 0,
                       .sha256 = shard.sha256,
                       .md5 = {}});
    }
    const auto read = [&](std::size_t i, const std::filesystem::path& file) {
      auto text = read_file(file);
      if (!text) {
        for (Diagnostic& error : std::move(text).errors()) errors.push_back(std::move(error));
      } else if (sha256_hex(*text) != wanted[i].sha256) {
        errors.push_back(wrong_shard(wanted[i]));
      } else {
        bytes[i] = std::move(*text);
      }
    };
    if (network) {
      bring_verified(
          files, roots_.network, cancellation, [&](std::size_t i, const Outcome<Done>& outcome) {
            if (outcome) return read(i, files[i].place);
            Diagnostic error = outcome.errors().front();
            errors.push_back(error.code == "R2W0220" ? wrong_shard(wanted[i]) : std::move(error));
          });
    } else {
      for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto file = ros2wasm::bring(wanted[i].url, roots_, cancellation);
        if (!file) return file.errors();
        if (!*file) return no_index(source_.url, "the shard `" + wanted[i].url + "` is not there");
        read(i, **file);
      }
    }
    if (!errors.empty()) return Diagnostics{errors.front()};
    return bytes;
  }

  static Diagnostic wrong_shard(const Shard& shard) {
    return Diagnostic{.code = "R2W0238",
                      .kind = FailureKind::kEnvironment,
                      .message = "the part of an index that has `" + shard.name + "` is damaged",
                      .why = {"its sha256 is not " + shard.sha256, "it is at " + shard.url}};
  }

  /// As in RepodataIndex: a `.tar.bz2` is not needed where the same is there as a good `.conda`.
  void add(const JsonValue& shard, SpecTable& specs, RepoIndex& into) {
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
        auto parsed = parse_record(*json, file_name, source_.place, specs);
        if (auto* good = std::get_if<PackageRecord>(&parsed)) {
          stems.emplace(archive_stem(file_name));
          into.records.push_back(std::move(*good));
        } else {
          into.left_out.push_back({.channel = source_.place.channel,
                                   .subdir = source_.place.subdir,
                                   .file_name = file_name,
                                   .reason = std::move(std::get<std::string>(parsed))});
        }
      }
    }
  }

  RepodataSource source_;
  ChannelRoots roots_;
  std::string shards_base_;
  std::vector<std::pair<std::string, std::string>> shards_;  ///< name and sha256, by name
  std::vector<std::string_view> names_;                      ///< into shards_, at the same places
};

}  // namespace

Outcome<std::unique_ptr<SubdirIndex>> open_shards(RepodataSource source,
                                                  const ChannelRoots& roots) {
  auto index = std::make_unique<ShardIndex>(std::move(source), roots);
  if (auto opened = index->open(); !opened) return std::move(opened).errors();
  return std::unique_ptr<SubdirIndex>(std::move(index));
}

}  // namespace ros2wasm
