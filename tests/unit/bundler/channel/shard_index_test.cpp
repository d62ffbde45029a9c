// Shards that are none, and MessagePack. That shards give what the flat form gives is shown in
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

TEST(ParseMsgpack, ValuesAndDamage) {
  using namespace std::string_literals;
  const auto value = parse_msgpack("\x82\xa1\x61\x01\xa1\x62\xc4\x02\x0f\xa0"s, "x", "R2W0202");
  ASSERT_TRUE(value.ok());
  EXPECT_EQ(value->find("a")->integer(), 1);
  EXPECT_EQ(value->text_of("b"), "0fa0");
  for (const std::string& bad :
       {"\x82\xa1"s, "\x81\x01\x01"s, "\xc1"s, "\x01\x01"s, std::string(999, '\x91')})
    EXPECT_FALSE(parse_msgpack(bad, "x", "R2W0202").ok());
}

}  // namespace
}  // namespace ros2wasm
