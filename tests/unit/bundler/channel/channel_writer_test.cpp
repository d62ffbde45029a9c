// Making channels: the index is what the archives say, and the same archives give the same bytes.
#include "bundler/channel/channel_writer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "bundler/archive/zstd.hpp"
#include "bundler/channel/msgpack_writer.hpp"
#include "bundler/channel/repodata_index.hpp"
#include "bundler/io/files.hpp"
#include "bundler/io/sha256.hpp"
#include "unit/bundler/support/small_channel.hpp"

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
  for (const char* name :
       {"noarch/repodata.json", "noarch/repodata.json.zst", "noarch/repodata_shards.msgpack.zst"}) {
    EXPECT_EQ(one.tree().read(std::string("channel/") + name),
              two.tree().read(std::string("channel/") + name))
        << name;
  }
}

/// Names of the files in the folder of shards, sorted.
std::vector<std::string> shards_in(const fs::path& subdir) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(subdir / "shards"))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(ChannelWriter, ShardsAreNamedByTheirHashAndStaleOnesGo) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {}, {"b >=1"});
  channel.add("b", "1.0", {});
  const fs::path newer = channel.add("b", "2.0", {});
  channel.write_index();
  const fs::path subdir = channel.folder() / "noarch";
  const auto shards = shards_in(subdir);
  ASSERT_EQ(shards.size(), 2U);  // one for each name
  for (const std::string& name : shards)
    EXPECT_EQ(hash_file(subdir / "shards" / name)->sha256 + ".msgpack.zst", name);

  const auto packed = read_file(subdir / "repodata_shards.msgpack.zst", kMostOfData);
  const auto index = zstd_decompressed(*packed, 1 << 20, "the index");
  ASSERT_TRUE(index.ok());
  EXPECT_TRUE(
      index->starts_with("\x83\xa4info\x83\xa8"
                         "base_url\xa0\xafshards_base_url\xa7shards/"
                         "\xa6subdir\xa6noarch\xa6shards\x82\xa1"
                         "a\xc4\x20"));
  EXPECT_TRUE(index->ends_with("\xa7version\x01"));

  fs::remove(newer);
  channel.tree().write("channel/noarch/shards/notes.txt", "mine");
  channel.write_index();
  const auto after = shards_in(subdir);
  EXPECT_EQ(after.size(), 3U);  // two shards and the other file, which is nobody's shard
  EXPECT_TRUE(fs::exists(subdir / "shards/notes.txt"));
  EXPECT_NE(after, shards);
}

TEST(ChannelWriter, ARecordInAShardIsAsTheFormatHasIt) {
  testing::SmallChannel channel;
  channel.add("a", "1.0", {}, {"b >=1"});
  channel.write_index();
  const fs::path subdir = channel.folder() / "noarch";
  const auto shard = zstd_decompressed(
      *read_file(subdir / "shards" / shards_in(subdir).front(), kMostOfData), 1 << 20, "a shard");
  ASSERT_TRUE(shard.ok());
  const auto has = [&shard](std::string_view part) {
    return shard->find(part) != std::string::npos;
  };
  EXPECT_TRUE(
      has("\x83\xa8packages\x80\xaepackages.conda\x81\xaf"
          "a-1.0-h_0.conda"));
  EXPECT_TRUE(
      has("\xa7"
          "depends\x91\xa5"
          "b >=1"));
  EXPECT_TRUE(has("\xa6sha256\xc4\x20"));  // bytes, not text
  EXPECT_TRUE(has("\xa3md5\xc4\x10"));
  EXPECT_TRUE(shard->ends_with("\xa7removed\x90"));
}

TEST(MsgpackWriter, TakesTheShortestForm) {
  MsgpackWriter out;
  out.array(16).map(16).text(std::string(31, 'x')).text(std::string(32, 'x'));
  EXPECT_EQ(out.data().substr(0, 7), (std::string("\xdc\0\x10\xde\0\x10\xbf", 7)));
  EXPECT_EQ(out.data().substr(38, 2), "\xd9\x20");
  const auto number = [](std::uint64_t value) { return MsgpackWriter().number(value).data(); };
  EXPECT_EQ(number(127), "\x7f");
  EXPECT_EQ(number(128), "\xcc\x80");
  EXPECT_EQ(number(256), (std::string("\xcd\x01\0", 3)));
  EXPECT_EQ(number(65'536), (std::string("\xce\0\x01\0\0", 5)));
  EXPECT_EQ(number(1ULL << 32U), (std::string("\xcf\0\0\0\x01\0\0\0\0", 9)));
  EXPECT_EQ(MsgpackWriter().bytes(std::string(300, 'x')).data().substr(0, 3), "\xc5\x01\x2c");
  EXPECT_EQ(MsgpackWriter().text(std::string(70'000, 'x')).data().substr(0, 5),
            (std::string("\xdb\0\x01\x11\x70", 5)));
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

/// As if the file had been written so long ago.
void make_older(const fs::path& file, std::chrono::minutes age) {
  fs::last_write_time(file, fs::file_time_type::clock::now() - age);
}

std::size_t read_by_index(const testing::SmallChannel& channel,
                          Reading reading = Reading::kChanged) {
  const auto summary = index_channel(channel.folder(), reading);
  EXPECT_TRUE(summary.ok());
  return summary.ok() ? summary->read : 0;
}

class Incremental : public ::testing::Test {
 protected:
  Incremental() {
    for (const fs::path& archive : {a_, b_}) make_older(archive, std::chrono::minutes(60));
    EXPECT_EQ(read_by_index(channel_), 2U);
    first_ = index();
  }

  std::string index() { return channel_.tree().read("channel/noarch/repodata.json"); }

  testing::SmallChannel channel_;
  fs::path a_ = channel_.add("a", "1.0", {{"x", "1"}}, {"b >=1"});
  fs::path b_ = channel_.add("b", "1.0", {});
  std::string first_;
};

TEST_F(Incremental, OnlyWhatHasChangedIsRead) {
  EXPECT_EQ(read_by_index(channel_), 0U);
  EXPECT_EQ(index(), first_);
  make_older(a_, std::chrono::minutes(30));
  EXPECT_EQ(read_by_index(channel_), 1U);
  EXPECT_EQ(index(), first_);
  EXPECT_EQ(read_by_index(channel_), 0U);
  make_older(channel_.add("c", "1.0", {}), std::chrono::minutes(20));
  EXPECT_EQ(read_by_index(channel_), 1U);
  EXPECT_NE(index(), first_);
  EXPECT_EQ(read_by_index(channel_, Reading::kAll), 3U);
}

TEST_F(Incremental, WhatIsGoneIsNotListed) {
  fs::rename(b_, channel_.tree() / "b.conda");
  EXPECT_EQ(read_by_index(channel_), 0U);
  EXPECT_EQ(index().find("b-1.0"), std::string::npos);
  EXPECT_NE(index().find("\"removed\":[]"), std::string::npos);
  fs::rename(channel_.tree() / "b.conda", b_);
  EXPECT_EQ(read_by_index(channel_), 1U);
  EXPECT_EQ(index(), first_);
}

TEST_F(Incremental, YoungArchivesAreReadAgain) {
  make_older(a_, std::chrono::minutes(-60));
  EXPECT_EQ(read_by_index(channel_), 1U);
  EXPECT_EQ(read_by_index(channel_), 1U);  // written to since, within a tick of the clock?
  // As if the run that read it had gone on for hours.
  make_older(channel_.folder() / "noarch/.ros2wasm-archives.json", std::chrono::minutes(-300));
  EXPECT_EQ(read_by_index(channel_), 1U);
}

TEST_F(Incremental, OtherBytesOfTheSameSizeAndTimeNeedAll) {
  const auto time = fs::last_write_time(a_);
  const std::string bytes(fs::file_size(a_), 'x');
  std::ofstream(a_, std::ios::in | std::ios::out).write(bytes.data(), std::ssize(bytes));
  fs::last_write_time(a_, time);
  EXPECT_EQ(read_by_index(channel_), 0U);
  const auto all = index_channel(channel_.folder(), Reading::kAll);
  ASSERT_FALSE(all.ok());
  EXPECT_EQ(all.errors().front().code.text(), "R2W0221");
}

TEST_F(Incremental, DamagedMemoryIsNone) {
  const fs::path memory = channel_.folder() / "noarch/.ros2wasm-archives.json";
  std::string text = channel_.tree().read("channel/noarch/.ros2wasm-archives.json");
  const std::size_t at = text.find("b >=1");
  ASSERT_NE(at, std::string::npos);
  for (const std::string& damaged :
       {text.substr(0, 70), text.replace(at, 5, "b >=2"), std::string()}) {
    std::ofstream(memory, std::ios::trunc) << damaged;
    EXPECT_EQ(read_by_index(channel_), 2U);
    EXPECT_EQ(index(), first_);
  }
}

}  // namespace
}  // namespace ros2wasm
