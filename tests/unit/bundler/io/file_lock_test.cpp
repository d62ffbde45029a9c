// One process at a time, and nobody without the lock.
#include "bundler/io/file_lock.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

TEST(FileLock, IsHeldByOneAtATime) {
  const testing::TemporaryTree tree;
  auto first = FileLock::take(tree / "work/a.lock", {});
  ASSERT_TRUE(first);
  const std::atomic<bool> stop = true;
  const auto refused = FileLock::take(tree / "work/a.lock", Cancellation(stop));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.errors().front().kind, FailureKind::kInterrupted);
  std::thread other([&] { EXPECT_TRUE(FileLock::take(tree / "work/a.lock", {})); });
  first = FileLock::take(tree / "work/b.lock", {});  // lets the other one go
  other.join();
}

TEST(FileLock, NoTwoHoldersMeet) {
  const testing::TemporaryTree tree;
  std::atomic<int> holders = 0;
  std::atomic<int> turns = 0;
  const auto take_turns = [&] {
    for (int i = 0; i < 40; ++i) {
      const auto lock = FileLock::take(tree / "a.lock", {});
      ASSERT_TRUE(lock);
      EXPECT_EQ(++holders, 1);
      std::this_thread::yield();
      ++turns;
      EXPECT_EQ(--holders, 0);
    }
  };
  std::thread other(take_turns);
  take_turns();
  other.join();
  EXPECT_EQ(turns, 80);
}

TEST(FileLock, AFolderIsSharedOrHeldAlone) {
  const testing::TemporaryTree tree;
  const std::atomic<bool> stop = true;
  const Cancellation at_once(stop);
  const auto take = [&](bool is_shared) {
    return FileLock::take_folder(tree.root(), is_shared, at_once);
  };
  {
    const auto one = take(true);
    const auto two = take(true);
    ASSERT_TRUE(one && *one && two && *two);
    EXPECT_EQ(take(false).errors().front().kind, FailureKind::kInterrupted);
  }
  const auto alone = take(false);
  ASSERT_TRUE(alone && *alone);
  EXPECT_EQ(take(true).errors().front().kind, FailureKind::kInterrupted);
  EXPECT_EQ(FileLock::take_folder(tree / "absent", true, {}).errors().front().code.text(),
            "R2W0210");
}

TEST(FileLock, OneThatCannotBeHadIsAnError) {
  const testing::TemporaryTree tree;
  tree.write("file", "");
  EXPECT_EQ(FileLock::take(tree / "file/a.lock", {}).errors().front().code.text(), "R2W0211");
  std::filesystem::create_directory(tree / "folder.lock");
  EXPECT_EQ(FileLock::take(tree / "folder.lock", {}).errors().front().code.text(), "R2W0211");
}

}  // namespace
}  // namespace ros2wasm
