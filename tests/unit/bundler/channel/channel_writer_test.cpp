// Making channels: the index is what the archives say, and the same archives give the same bytes.
#include "bundler/channel/channel_writer.hpp"

#include <gtest/gtest.h>

#include "unit/bundler/support/small_channel.hpp"
#include "unit/support/conda_data.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

TEST(ChannelWriter, WhatIsWrittenIsRead) {
  testing::SmallChannel channel;
  channel.add("b", "1.0", {{"share/b", "b"}}, {"a >=1"});
  channel.add("a", "2.0", {{"share/a", "a"}});
  channel.write_index();
  const RepoIndex index = channel.read();
  ASSERT_EQ(index.records.size(), 2U);
  EXPECT_EQ(index.records[0].file_name, "a-2.0-h_0.conda");
  EXPECT_EQ(index.records[1].depends, std::vector<std::string>{"a >=1"});
  EXPECT_EQ(index.records[1].sha256.size(), 64U);
  EXPECT_EQ(index.records[1].size, fs::file_size(channel.folder() / "noarch/b-1.0-h_0.conda"));
  EXPECT_EQ(index.records[1].license, "MIT");
}

TEST(ChannelWriter, TheOrderOfAddingDoesNotMatter) {
  testing::SmallChannel one;
  testing::SmallChannel two;
  one.add("a", "1.0", {{"x", "1"}});
  one.add("b", "1.0", {});
  two.add("b", "1.0", {});
  two.add("a", "1.0", {{"x", "1"}});
  one.write_index();
  two.write_index();
  for (const char* name : {"noarch/repodata.json", "noarch/repodata.json.zst"}) {
    EXPECT_EQ(one.tree().read(std::string("channel/") + name),
              two.tree().read(std::string("channel/") + name))
        << name;
  }
}

TEST(ChannelWriter, AnEmptyChannelHasANoarchIndex) {
  const testing::TemporaryTree tree;
  fs::create_directories(tree / "c/emscripten-wasm32");
  ASSERT_TRUE(index_channel(tree / "c").ok());
  EXPECT_TRUE(fs::exists(tree / "c/noarch/repodata.json"));
  EXPECT_TRUE(fs::exists(tree / "c/emscripten-wasm32/repodata.json.zst"));
  EXPECT_FALSE(index_channel(tree / "absent").ok());
}

TEST(ChannelWriter, MisplacedAndDamagedArchivesAreSaidTogether) {
  testing::SmallChannel channel;
  const fs::path archive = channel.add("a", "1.0", {});
  fs::rename(archive, channel.folder() / "noarch/b-1.0-h_0.conda");
  channel.tree().write("channel/noarch/c-1.0-0.conda", "not a zip");
  const auto summary = index_channel(channel.folder());
  ASSERT_FALSE(summary.ok());
  ASSERT_EQ(summary.errors().size(), 2U);
  EXPECT_EQ(summary.errors()[0].code, "R2W0205");
  EXPECT_EQ(summary.errors()[1].code, "R2W0221");
}

TEST(ChannelWriter, FinishedArchivesGoToTheirSubdirectory) {
  testing::SmallChannel channel;
  const fs::path archive = channel.add("a", "1.0", {});
  const auto copied = copy_to_channel(channel.tree() / "other", archive);
  ASSERT_TRUE(copied.ok());
  EXPECT_EQ(*copied, channel.tree() / "other/noarch/a-1.0-h_0.conda");
  EXPECT_TRUE(index_channel(channel.tree() / "other").ok());
}

TEST(ChannelWriter, PublicArchivesAreIndexedAsTheirOwnIndexSays) {
  const auto folder = testing::conda_data("mini_channel/win-64");
  if (!folder) return;  // the data is not part of the repository
  const testing::TemporaryTree tree;
  fs::create_directories(tree / "c/win-64");
  for (const auto& entry : fs::directory_iterator(*folder)) {
    if (entry.path().extension() == ".conda" || entry.path().extension() == ".bz2") {
      fs::copy_file(entry.path(), tree / "c/win-64" / entry.path().filename());
    }
  }
  ASSERT_TRUE(index_channel(tree / "c").ok());
  const auto ours = parse_repodata(tree.read("c/win-64/repodata.json"), "c", "win-64");
  const auto file = testing::conda_data("mini_channel/win-64/repodata.json");
  std::ifstream stream(*file, std::ios::binary);
  const auto theirs =
      parse_repodata(std::string(std::istreambuf_iterator<char>(stream), {}), "c", "win-64");
  ASSERT_TRUE(ours.ok() && theirs.ok());
  ASSERT_FALSE(ours->records.empty());
  for (const PackageRecord& record : ours->records) {
    const auto twin = std::find_if(
        theirs->records.begin(), theirs->records.end(),
        [&](const PackageRecord& other) { return other.file_name == record.file_name; });
    ASSERT_NE(twin, theirs->records.end()) << record.file_name;
    EXPECT_EQ(record.sha256, twin->sha256);
    EXPECT_EQ(record.md5, twin->md5);
    EXPECT_EQ(record.size, twin->size);
    EXPECT_EQ(record.depends, twin->depends);
  }
}

}  // namespace
}  // namespace ros2wasm
