// Shards that are none. That shards give what the flat form gives is shown in
// tests/network and tests/conda_data.
#include "bundler/channel/shard_index.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/channel_index.hpp"
#include "bundler/channel/shard_format.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

using namespace std::string_literals;

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
    EXPECT_EQ(index.errors().front().code.text(), "R2W0202");
  }
}

/// Why it cannot be read, or nothing.
std::string fault_of_list(const std::string& text) {
  const auto list = read_shard_list(zstd_compressed(text, 1), "the list");
  return list.ok() ? std::string() : list.errors().front().why.front();
}

std::string fault_of_shard(const std::string& text) {
  SpecTable specs;
  RepoIndex index;
  const auto done = read_shard(zstd_compressed(text, 1), "the shard",
                               {.channel = "c", .subdir = "noarch", .base_url = ""}, specs, index);
  return done.ok() ? std::string() : done.errors().front().message;
}

constexpr std::string_view kNoMsgpack = "`the shard` is not valid MessagePack";

TEST(ShardIndex, AListEndsWithTheFirstShardWithoutHash) {
  EXPECT_EQ(fault_of_list("\x81\xa6shards\x81\xa1x\xc4\x20"s + std::string(32, 'h')), "");
  // Two million more pairs would follow.
  EXPECT_EQ(fault_of_list("\x81\xa6shards\xdf\x00\x20\x00\x00\xa1x\xa0"s),
            "the shard of `x` has no sha256");
}

TEST(ShardIndex, SmallFilesMakeNoMillionsOfValues) {
  const std::string head = "\xdd\x00\x20\x00\x00"s;  // an array of 2^21
  EXPECT_EQ(fault_of_list("\x81\xa4info"s + head + std::string(1U << 21U, '\xc0')),
            fault_of_list("\x81\xa4info"s));
  EXPECT_EQ(fault_of_shard("\x81\xa7removed\x91\xa1x"s), "");
  EXPECT_EQ(fault_of_shard("\x81\xa7removed\x91\xc0"s), kNoMsgpack);
  EXPECT_EQ(fault_of_shard("\x81\xa7removed"s + head + std::string(1U << 21U, '\xa0')), kNoMsgpack);
  std::string records;
  for (int i = 0; i < (1 << 20); ++i) records += "\xa0\xc0";
  EXPECT_EQ(fault_of_shard("\x81\xa8packages\xdf\x00\x10\x00\x00"s + records), kNoMsgpack);
}

}  // namespace
}  // namespace ros2wasm
