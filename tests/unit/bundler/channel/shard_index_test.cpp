// Shards that are none. That shards give what the flat form gives is shown in
// tests/network and tests/conda_data.
#include "bundler/channel/shard_index.hpp"

#include <gtest/gtest.h>

#include "bundler/channel/channel_index.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

Outcome<RepoIndex> read_channel(const testing::TemporaryTree& tree) {
  const ChannelRoots roots{
      .working_directory = tree.root(), .embedded = {}, .cache = tree / "cache", .network = {}};
  const std::vector<ChannelSource> sources{{.name = "./c", .span = {}}};
  return load_channels(sources, roots);
}

TEST(ShardIndex, WhatIsNoListOfShardsIsSaid) {
  const testing::TemporaryTree tree;
  for (const std::string bytes : {"", "(\xb5/\xfd", "no zstd at all"}) {
    tree.write("c/noarch/repodata_shards.msgpack.zst", bytes);
    const auto index = read_channel(tree);
    ASSERT_FALSE(index.ok());
    EXPECT_EQ(index.errors().front().code, "R2W0202");
  }
}

}  // namespace
}  // namespace ros2wasm
