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
  std::atomic<bool> released = false;
  std::thread other([&] {
    EXPECT_TRUE(FileLock::take(tree / "work/a.lock", {}));
    EXPECT_TRUE(released);
  });
  released = true;
  first = FileLock::take(tree / "work/b.lock", {});  // lets the other one go
  other.join();
}

TEST(FileLock, OneThatCannotBeHadIsAnError) {
  const testing::TemporaryTree tree;
  tree.write("file", "");
  EXPECT_EQ(FileLock::take(tree / "file/a.lock", {}).errors().front().code, "R2W0211");
  std::filesystem::create_directory(tree / "folder.lock");
  EXPECT_EQ(FileLock::take(tree / "folder.lock", {}).errors().front().code, "R2W0211");
}

}  // namespace
}  // namespace ros2wasm
