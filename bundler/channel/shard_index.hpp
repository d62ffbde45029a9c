// A sharded index (CEP 16): one small file says which names there are, and one file per name, named
// by its sha256, has that name's records. Only the shards of names that are asked for are fetched.
#pragma once

#include <memory>

#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/repodata_index.hpp"

namespace ros2wasm {

/// `source.file` is the repodata_shards.msgpack.zst. R2W0202 it cannot be read; reading records can
/// also give R2W0238 (a shard has another sha256 than its name) and the errors of the network.
[[nodiscard]] Outcome<std::unique_ptr<SubdirIndex>> open_shards(RepodataSource source,
                                                                const ChannelRoots& roots);

}  // namespace ros2wasm
