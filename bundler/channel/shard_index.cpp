// See shard_index.hpp.
#include "bundler/channel/shard_index.hpp"

#include <algorithm>
#include <utility>

#include "bundler/channel/channel_address.hpp"
#include "bundler/channel/read_in_parts.hpp"
#include "bundler/channel/shard_format.hpp"
#include "bundler/channel/transport.hpp"
#include "bundler/channel/verified_files.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"

namespace ros2wasm {
namespace {

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
    const auto bytes = read_file(source_.file, kMostOfData);
    if (!bytes) return bytes.errors();
    auto list = read_shard_list(*bytes, source_.url);
    if (!list) return std::move(list).errors();
    const std::string here = source_.place.base_url;
    shards_base_ = with_base_url(std::move(list->shards_base_url), here);
    source_.place.base_url = with_base_url(std::move(list->base_url), here);
    list_ = std::move(*list);
    return Done{};
  }

  [[nodiscard]] std::span<const std::string_view> names() override {
    if (names_.empty()) {
      for (const auto& [name, hash] : list_.shards) names_.push_back(name);
      std::sort(names_.begin(), names_.end());
    }
    return names_;
  }

  [[nodiscard]] Outcome<Done> read(std::span<const std::string> names, SpecTable& specs,
                                   RepoIndex& into, const Cancellation& cancellation) override {
    std::vector<Shard> wanted;
    for (const std::string& name : names) {
      const auto found = list_.shards.find(name);
      if (found == list_.shards.end()) continue;
      const std::string sha256 = found->second.hex();
      wanted.push_back(
          {.name = name, .url = shards_base_ + "/" + sha256 + ".msgpack.zst", .sha256 = sha256});
    }
    const auto files = bring(wanted, cancellation);
    if (!files) return files.errors();
    return read_in_parts(
        wanted.size(), specs, into,
        [&](std::size_t first, std::size_t last, SpecTable& table, RepoIndex& part) {
          Outcome<Done> done = Done{};
          for (std::size_t i = first; i < last && done; ++i) {
            done = cancellation.requested() ? Outcome<Done>(interrupted())
                                            : read(wanted[i], (*files)[i], table, part);
          }
          return done;
        });
  }

 private:
  /// Where these shards are on this machine.
  Outcome<std::vector<std::filesystem::path>> bring(const std::vector<Shard>& wanted,
                                                    const Cancellation& cancellation) {
    std::vector<std::filesystem::path> places;
    places.reserve(wanted.size());
    if (!is_network_url(shards_base_)) {
      for (const Shard& shard : wanted) {
        const auto file = ros2wasm::bring(shard.url, roots_, cancellation);
        if (!file) return file.errors();
        if (!*file) return no_index(source_.url, "the shard `" + shard.url + "` is not there");
        places.push_back(**file);
      }
      return places;
    }
    std::vector<WantedFile> files;
    for (const Shard& shard : wanted) {
      places.push_back(roots_.cache / "shards" / shard.sha256.substr(0, 2) /
                       (shard.sha256 + ".msgpack.zst"));
      files.push_back({.what = "the part of an index that has `" + shard.name + "`",
                       .url = shard.url,
                       .place = places.back(),
                       .size = 0,
                       .sha256 = shard.sha256,
                       .md5 = {}});
    }
    Diagnostics errors;
    bring_verified(
        files, roots_.network, cancellation, [&](std::size_t i, const Outcome<Done>& outcome) {
          if (outcome) return;
          Diagnostic error = outcome.errors().front();
          errors.push_back(error.code == "R2W0220" ? wrong_shard(wanted[i]) : std::move(error));
        });
    if (!errors.empty()) return Diagnostics{errors.front()};
    return places;
  }

  /// Runs on several threads.
  Outcome<Done> read(const Shard& shard, const std::filesystem::path& file, SpecTable& specs,
                     RepoIndex& into) const {
    const auto bytes = read_file(file, kMostOfData);
    if (!bytes) return bytes.errors();
    if (sha256_hex(*bytes) != shard.sha256) return wrong_shard(shard);
    return read_shard(*bytes, shard.url, source_.place, specs, into);
  }

  static Diagnostic wrong_shard(const Shard& shard) {
    return Diagnostic{.code = "R2W0238",
                      .kind = FailureKind::kEnvironment,
                      .message = "the part of an index that has `" + shard.name + "` is damaged",
                      .why = {"its sha256 is not " + shard.sha256, "it is at " + shard.url}};
  }

  RepodataSource source_;
  ChannelRoots roots_;
  std::string shards_base_;
  ShardList list_;
  std::vector<std::string_view> names_;  ///< once they were asked for
};

}  // namespace

Outcome<std::unique_ptr<SubdirIndex>> open_shards(RepodataSource source,
                                                  const ChannelRoots& roots) {
  auto index = std::make_unique<ShardIndex>(std::move(source), roots);
  if (auto opened = index->open(); !opened) return std::move(opened).errors();
  return std::unique_ptr<SubdirIndex>(std::move(index));
}

}  // namespace ros2wasm
