// The store: verified, cached, healed when damaged, and safe when many want the same package.
#include "bundler/store/store.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <thread>

#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

/// Files below the cache that are not complete packages.
std::size_t left_behind(const testing::SmallChannel& channel) {
  std::error_code error;
  const fs::path folder = channel.tree() / "cache/packages/unfinished";
  return fs::exists(folder, error)
             ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}))
             : 0;
}

std::string code_of(const Outcome<fs::path>& outcome) {
  return outcome.ok() ? "ok" : outcome.errors().front().code.text();
}

class StoreTest : public ::testing::Test {
 protected:
  void SetUp() override {
    archive_ = channel_.add("a", "1.0", {{"include/a.h", "int a;"}, {"share/a/x", "x"}});
    channel_.write_index();
    record_ = channel_.record("a");
  }
  testing::SmallChannel channel_;
  fs::path archive_;
  PackageRecord record_;
};

TEST_F(StoreTest, UnpacksOnceAndKeeps) {
  const auto first = channel_.store().unpacked(record_);
  ASSERT_TRUE(first.ok());
  EXPECT_TRUE(fs::exists(*first / "include/a.h"));
  EXPECT_TRUE(fs::exists(*first / "info/index.json"));
  fs::remove(archive_);
  const auto second = channel_.store().unpacked(record_);  // without the archive
  ASSERT_TRUE(second.ok());
  EXPECT_EQ(*first, *second);
  EXPECT_EQ(left_behind(channel_), 0U);
}

TEST_F(StoreTest, FilesAreReadOnly) {
  const auto folder = channel_.store().unpacked(record_);
  ASSERT_TRUE(folder.ok());
  EXPECT_EQ(fs::status(*folder / "include/a.h").permissions() & fs::perms::owner_write,
            fs::perms::none);
}

TEST_F(StoreTest, ADamagedCopyIsMadeAgain) {
  const auto folder = channel_.store().unpacked(record_);
  ASSERT_TRUE(folder.ok());
  fs::permissions(*folder / "include/a.h", fs::perms::owner_write, fs::perm_options::add);
  std::ofstream(*folder / "include/a.h") << "int b;";
  const auto again = channel_.store().unpacked(record_);
  ASSERT_TRUE(again.ok());
  std::ifstream healed(*again / "include/a.h");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(healed), {}), "int a;");
}

TEST_F(StoreTest, ADamagedInfoIsMadeAgain) {
  const auto folder = channel_.store().unpacked(record_);
  ASSERT_TRUE(folder.ok());
  EXPECT_EQ(package_fault(*folder), "");
  // A file and, to fit, the list of files.
  const fs::path list = *folder / "info/paths.json";
  for (const fs::path& path : {list, *folder / "include/a.h"})
    fs::permissions(path, fs::perms::owner_write, fs::perm_options::add);
  std::ofstream(*folder / "include/a.h") << "int b;";
  std::ofstream(list) << R"({"paths_version": 1, "paths": []})";
  EXPECT_EQ(package_fault(*folder), "info is not as it was unpacked");
  const auto again = channel_.store().unpacked(record_);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(package_fault(*again), "");
  std::ifstream healed(*again / "include/a.h");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(healed), {}), "int a;");
}

// Guarantee, hostile input: an archive with other bytes than the lock says is not opened
TEST_F(StoreTest, WrongArchivesAreNotOpened) {
  std::ofstream(archive_, std::ios::app) << "x";
  EXPECT_EQ(code_of(channel_.store().unpacked(record_)), "R2W0220");
  record_.size = 0;
  EXPECT_EQ(code_of(channel_.store().unpacked(record_)), "R2W0220");
  record_.sha256.clear();
  EXPECT_EQ(code_of(channel_.store().unpacked(record_)), "R2W0220");  // by md5
  record_.md5.clear();
  EXPECT_EQ(code_of(channel_.store().unpacked(record_)), "R2W0220");  // nobody can tell
  fs::remove(archive_);
  EXPECT_EQ(code_of(channel_.store().unpacked(record_)), "R2W0228");
  EXPECT_EQ(left_behind(channel_), 0U);
  EXPECT_FALSE(fs::exists(channel_.tree() / "cache/packages/00"));
}

TEST_F(StoreTest, OldChannelsWithMd5Only) {
  record_.sha256.clear();
  EXPECT_EQ(code_of(channel_.store().unpacked(record_)), "ok");
}

TEST_F(StoreTest, RefusedArchivesLeaveNothing) {
  const Store strict(channel_.roots(), {.members = 1});
  EXPECT_EQ(code_of(strict.unpacked(record_)), "R2W0225");
  EXPECT_EQ(left_behind(channel_), 0U);
}

TEST_F(StoreTest, CancellationLeavesNothing) {
  const std::atomic<bool> stop{true};
  EXPECT_EQ(code_of(channel_.store().unpacked(record_, Cancellation(stop))), "R2W0903");
  EXPECT_EQ(left_behind(channel_), 0U);
}

TEST_F(StoreTest, ManyAtOnceGetTheSameFolder) {
  // Times in archives ask for the time zone. Where none is named the C library copies the name of
  // its file each time, under a lock of its own that ThreadSanitizer does not see.
  ::setenv("TZ", "UTC", 1);
  tzset();
  std::vector<std::string> answers(8);
  std::vector<std::thread> threads;
  for (std::string& answer : answers) {
    threads.emplace_back([this, &answer] {
      const auto folder = channel_.store().unpacked(record_);
      answer = folder.ok() ? folder->string() : folder.errors().front().code.text();
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::string& answer : answers) EXPECT_EQ(answer, answers.front());
  EXPECT_TRUE(fs::exists(fs::path(answers.front()) / "include/a.h"));
  EXPECT_EQ(left_behind(channel_), 0U);
}

}  // namespace
}  // namespace ros2wasm
