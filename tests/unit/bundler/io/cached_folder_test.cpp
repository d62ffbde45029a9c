// A folder that is kept is whole, or made again.
#include "bundler/io/cached_folder.hpp"

#include <gtest/gtest.h>

#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;
using testing::TemporaryTree;

TEST(KeptFolder, IsTrustedWithTheStampOfItsKeyOnly) {
  const TemporaryTree tree;
  EXPECT_FALSE(is_kept(tree / "kept", "key"));
  tree.write("kept/include/a.h", "half");
  EXPECT_FALSE(is_kept(tree / "kept", "key")) << "a folder that was never finished";
  tree.write("made/include/a.h", "whole");
  ASSERT_TRUE(keep_folder(tree / "made", tree / "kept", "key"));
  EXPECT_TRUE(is_kept(tree / "kept", "key"));
  EXPECT_FALSE(is_kept(tree / "kept", "another key"));
  EXPECT_EQ(tree.read("kept/include/a.h"), "whole");
  EXPECT_FALSE(fs::exists(tree / "made"));
}

TEST(KeptFolder, WhoeverIsFasterWins) {
  const TemporaryTree tree;
  tree.write("first/x", "the same");
  tree.write("second/x", "the same");
  ASSERT_TRUE(keep_folder(tree / "first", tree / "kept", "key"));
  const auto written = fs::last_write_time(tree / "kept/x");
  EXPECT_TRUE(keep_folder(tree / "second", tree / "kept", "key"));
  EXPECT_EQ(fs::last_write_time(tree / "kept/x"), written);
}

TEST(KeptFolder, WhereNothingCanBeMadeTheReasonIsSaid) {
  const TemporaryTree tree;
  tree.write("file", "");
  tree.write("made/x", "");
  const auto kept = keep_folder(tree / "made", tree / "file/kept", "key");
  ASSERT_FALSE(kept);
  EXPECT_EQ(kept.errors().front().code.text(), "R2W0211");
}

}  // namespace
}  // namespace ros2wasm
