#include "bundler/workspace/page_bags.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
namespace fs = std::filesystem;

const std::string kBag{"\x89MCAP0\r\nmore", 12};

TEST(PageBags, ReadsThemInOrder) {
  const testing::TemporaryTree tree;
  tree.write("bags/walk.mcap", kBag);
  tree.write("run.mcap", kBag);
  const auto files = read_page_bags(
      tree.root(), {{.value = "./run.mcap", .span = {}}, {.value = "bags/walk.mcap", .span = {}}});
  ASSERT_TRUE(files.ok());
  ASSERT_EQ(files->size(), 2U);
  EXPECT_EQ((*files)[0].path, "run.mcap");
  EXPECT_EQ((*files)[1].path, "bags/walk.mcap");
  EXPECT_EQ((*files)[1].bytes, kBag);
  EXPECT_EQ(page_bag_path("./bags/walk.mcap"), "bags/bags/walk.mcap");
}

TEST(PageBags, NamesThoseThatAreCut) {
  const testing::TemporaryTree tree;
  const std::string sign = kBag.substr(0, 8);
  tree.write("whole.mcap", kBag + sign);
  tree.write("cut.mcap", kBag);
  tree.write("begun.mcap", sign);
  const std::vector<Spanned<std::string>> named{{.value = "whole.mcap", .span = {}},
                                                {.value = "cut.mcap", .span = {}},
                                                {.value = "begun.mcap", .span = {}}};
  const auto files = read_page_bags(tree.root(), named);
  ASSERT_TRUE(files.ok());
  const Diagnostics warnings = cut_bags(*files, named);
  ASSERT_EQ(warnings.size(), 2U);
  EXPECT_EQ(warnings[0].message, "the bag `cut.mcap` is not whole");
  EXPECT_EQ(warnings[0].severity, Severity::kWarning);
}

TEST(PageBags, RefusesWhatIsNoBagOfTheFolder) {
  const testing::TemporaryTree outside;
  const testing::TemporaryTree tree;
  tree.write("a/run.mcap", kBag);
  tree.write("b/run.mcap", kBag);
  tree.write("old.bag", "#ROSBAG V2.0");
  fs::create_symlink(outside.write("secret.mcap", kBag), tree / "link.mcap");
  std::vector<Spanned<std::string>> named;
  for (const char* path :
       {"a/run.mcap", "b/run.mcap", "old.bag", "link.mcap", "gone.mcap", "../x.mcap"})
    named.push_back({.value = path, .span = {}});
  const auto files = read_page_bags(tree.root(), named);
  ASSERT_FALSE(files.ok());
  ASSERT_EQ(files.errors().size(), 5U);
  for (const Diagnostic& error : files.errors()) EXPECT_EQ(error.code, "R2W0118");
  EXPECT_EQ(files.errors()[0].why.front(), "another bag has the name `run.mcap` already");
  EXPECT_EQ(files.errors()[1].why.front(), "it is not an MCAP file, which is what the page plays");
  EXPECT_EQ(files.errors()[4].why.front(), "it is not in the folder of the manifest");
}

}  // namespace
}  // namespace ros2wasm
