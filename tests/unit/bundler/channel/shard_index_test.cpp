// The public mini channel has both forms of its index: they must give the same records.
#include "bundler/channel/shard_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "unit/bundler/support/small_channel.hpp"
#include "unit/support/conda_data.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

Outcome<RepoIndex> read_channel(const testing::TemporaryTree& tree) {
  const ChannelRoots roots{.working_directory = tree.root(),
                           .embedded = {},
                           .cache = tree / "cache",
                           .network = {},
                           .platform = "linux-64"};
  const std::vector<ChannelSource> sources{{.name = "./c", .span = {}}};
  auto index = load_channels(sources, roots);
  if (index) {
    std::sort(index->records.begin(), index->records.end(),
              [](const PackageRecord& a, const PackageRecord& b) { return a.url < b.url; });
  }
  return index;
}

TEST(ShardIndex, APublicChannelIsTheSameFlatAndSharded) {
  const auto public_channel = testing::conda_data("mini_channel");
  if (!public_channel) return;  // the data is not part of the repository
  const testing::TemporaryTree tree;
  fs::copy(*public_channel, tree / "c", fs::copy_options::recursive);
  const auto sharded = read_channel(tree);
  fs::remove(tree / "c/linux-64/repodata_shards.msgpack.zst");
  const auto flat = read_channel(tree);
  ASSERT_TRUE(sharded.ok() && flat.ok());
  EXPECT_EQ(sharded->records, flat->records);
  EXPECT_EQ(sharded->names, flat->names);
  EXPECT_EQ(flat->names, (std::vector<std::string>{"libgcc-ng", "zlib"}));
  const auto request = testing::request_for({"zlib"});
  EXPECT_EQ(testing::answer(request, *sharded), testing::answer(request, *flat));
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
