// A file that is being downloaded belongs to one process, whatever happens to its bytes.
#include "bundler/io/part_file.hpp"

#include <gtest/gtest.h>

#include "bundler/io/download.hpp"
#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {

namespace fs = std::filesystem;

TEST(PartFile, IsHeldByOneAndGoesOnWithTheNext) {
  const testing::TemporaryTree tree;
  const fs::path place = tree / "x.conda";
  {
    const auto first = PartFile::open(place);
    ASSERT_TRUE(first);
    EXPECT_TRUE(first->resumable());
    tree.write("x.conda.part", "begin");
    const auto second = PartFile::open(place);
    ASSERT_TRUE(second);
    EXPECT_FALSE(second->resumable());
    EXPECT_NE(second->path(), first->path());
  }
  EXPECT_EQ(tree.read("x.conda.part"), "begin");
  auto next = PartFile::open(place);
  ASSERT_TRUE(next);
  EXPECT_TRUE(next->resumable());
  ASSERT_TRUE(next->finish(place));
  EXPECT_EQ(tree.read("x.conda"), "begin");
}

TEST(PartFile, StaysHeldWhenItsBytesAreOfNoUse) {
  const testing::TemporaryTree tree;
  const fs::path place = tree / "x.conda";
  {
    const auto held = PartFile::open(place);
    ASSERT_TRUE(held);
    tree.write("x.conda.part", "as many bytes as there should be, or more");
    // Nobody answers there; the bytes are given up before the server is asked.
    const DownloadSource nowhere{
        .url = "http://127.0.0.1:1/x", .shown_url = "x", .user_info = {}, .bearer = {}};
    const auto ends = download_all(
        {.http = {}, .retries = 0},
        {{.sources = {nowhere}, .headers = {}, .file = held->path(), .resume = true, .size = 5}},
        {});
    EXPECT_FALSE(ends.front());
    const auto other = PartFile::open(place);
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->resumable()) << "two would write one file";
  }
  EXPECT_TRUE(fs::is_empty(tree.root())) << "an empty beginning is of no use";
}

}  // namespace
}  // namespace ros2wasm
