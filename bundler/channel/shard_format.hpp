// Bytes of a sharded index (CEP 16): the list of shards, and a shard with the records of one name.
// Pure.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/repodata_record.hpp"
#include "bundler/channel/spec_table.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

struct ListedShard {
  std::string_view name;  ///< of the package
  std::string_view hash;  ///< sha256 of the shard's file: 32 bytes, or 64 digits of lower-case hex

  [[nodiscard]] std::string sha256() const;  ///< hex
  auto operator<=>(const ListedShard&) const = default;
};

struct ShardList {
  std::string base_url;                 ///< of archives; absolute or below the folder of the list
  std::string shards_base_url;          ///< of the shards' files; likewise
  std::vector<ListedShard> shards;      ///< sorted
  std::unique_ptr<std::string> listed;  ///< what the shards' names and hashes are views of
};

/// Of a repodata_shards.msgpack.zst. R2W0202; `url` is for messages.
[[nodiscard]] Outcome<ShardList> read_shard_list(std::string_view bytes, const std::string& url);

/// Adds the records of a shard to `into`, those that cannot be used to its `left_out`. R2W0202;
/// `url` is for messages.
[[nodiscard]] Outcome<Done> read_shard(std::string_view bytes, const std::string& url,
                                       const RecordPlace& place, SpecTable& specs, RepoIndex& into);

}  // namespace ros2wasm
