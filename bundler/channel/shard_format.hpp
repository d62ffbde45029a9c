// Bytes of a sharded index (CEP 16): the list of shards, and a shard with the records of one name.
// Pure.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/repodata_record.hpp"
#include "bundler/channel/spec_table.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The sha256 of a shard's file.
struct ShardHash {
  std::string_view bytes;  ///< 32 of them, or 64 digits of lower-case hex

  [[nodiscard]] std::string hex() const;
};

struct ShardList {
  std::string base_url;         ///< of archives; absolute or below the folder of the list
  std::string shards_base_url;  ///< of the shards' files; likewise
  std::unordered_map<std::string_view, ShardHash> shards;  ///< by the name of the package
  std::unique_ptr<std::string> listed;  ///< what the shards' names and hashes are views of
};

/// Reads the bytes of a repodata_shards.msgpack.zst. R2W0202; `url` is for messages.
[[nodiscard]] Outcome<ShardList> read_shard_list(std::string_view bytes, const std::string& url);

/// Adds the records of a shard to `into`, those that cannot be used to its `left_out`. R2W0202;
/// `url` is for messages.
[[nodiscard]] Outcome<Done> read_shard(std::string_view bytes, const std::string& url,
                                       const RecordPlace& place, SpecTable& specs, RepoIndex& into);

}  // namespace ros2wasm
