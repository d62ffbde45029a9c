// See shard_index.hpp.
#include "bundler/channel/shard_index.hpp"

#include <algorithm>
#include <utility>

#include "bundler/channel/channel_address.hpp"
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
    const auto bytes = read_file(source_.file);
    if (!bytes) return bytes.errors();
    auto list = read_shard_list(*bytes, source_.url);
    if (!list) return std::move(list).errors();
    const std::string here = source_.place.base_url;
    shards_base_ = with_base_url(std::move(list->shards_base_url), here);
    source_.place.base_url = with_base_url(std::move(list->base_url), here);
    list_ = std::move(*list);
    names_.reserve(list_.shards.size());
    for (const ListedShard& shard : list_.shards) names_.push_back(shard.name);
    return Done{};
  }

  [[nodiscard]] std::span<const std::string_view> names() const override { return names_; }

  [[nodiscard]] Outcome<Done> read(std::span<const std::string> names, SpecTable& specs,
                                   RepoIndex& into, const Cancellation& cancellation) override {
    std::vector<Shard> wanted;
    for (const std::string& name : names) {
      const auto found = std::lower_bound(names_.begin(), names_.end(), name);
      if (found == names_.end() || *found != name) continue;
      const std::string sha256 =
          list_.shards[static_cast<std::size_t>(found - names_.begin())].sha256();
      wanted.push_back(
          {.name = name, .url = shards_base_ + "/" + sha256 + ".msgpack.zst", .sha256 = sha256});
    }
    auto bytes = bring(wanted, cancellation);
    if (!bytes) return std::move(bytes).errors();
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (cancellation.requested()) return interrupted();
      auto done = read_shard((*bytes)[i], wanted[i].url, source_.place, specs, into);
      if (!done) return done;
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

  RepodataSource source_;
  ChannelRoots roots_;
  std::string shards_base_;
  ShardList list_;
  std::vector<std::string_view> names_;  ///< of list_.shards, at the same places
};

}  // namespace

Outcome<std::unique_ptr<SubdirIndex>> open_shards(RepodataSource source,
                                                  const ChannelRoots& roots) {
  auto index = std::make_unique<ShardIndex>(std::move(source), roots);
  if (auto opened = index->open(); !opened) return std::move(opened).errors();
  return std::unique_ptr<SubdirIndex>(std::move(index));
}

}  // namespace ros2wasm
