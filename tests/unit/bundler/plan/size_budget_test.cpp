// Tests of the files that a budget counts, and of the message when a site exceeds it.
#include "bundler/plan/size_budget.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ros2wasm {
namespace {

SitePlan plan_of(const std::map<std::string, std::size_t>& files) {
  SitePlan plan;
  for (const auto& [path, size] : files) {
    plan.files.push_back({.path = path,
                          .reason = path.ends_with(".js") ? "runtime page" : "",
                          .bytes = std::string(size, 'x'),
                          .sha256 = {}});
  }
  return plan;
}

SitePlan small_plan() {
  return plan_of({{"app.js", 400},
                  {"programs/demo/talker.names", 9000},
                  {"programs/demo/talker.wasm", 300},
                  {"pyodide/pyodide.asm.wasm", 50},
                  {"share/demo/map.png", 20},
                  {"site.json", 5}});
}

SiteBudget total(std::uint64_t bytes) {
  return {.total = Spanned<std::uint64_t>{.value = bytes, .span = {.file = "workspace.yaml"}},
          .compressed = std::nullopt};
}

TEST(SizeBudget, CountsByPart) {
  const PartSizes wanted{{"lists", 5}, {"package demo", 320}, {"pyodide", 50}, {"runtime", 400}};
  EXPECT_EQ(part_sizes(small_plan()), wanted);
  EXPECT_EQ(read_sizes(sizes_text(wanted)), wanted);
}

TEST(SizeBudget, TheLastByteFits) {
  EXPECT_FALSE(over_budget(total(775), small_plan(), std::nullopt));
  const auto over = over_budget(total(774), small_plan(), std::nullopt);
  ASSERT_TRUE(over);
  EXPECT_EQ(over->code, "R2W0660");
  EXPECT_EQ(over->message, "the site has 775 B, 1 B more than its budget");
  EXPECT_EQ(over->span->file, "workspace.yaml");
  EXPECT_EQ(over->why, (std::vector<std::string>{
                           "there is no ros2wasm.sizes to compare with; its parts, in bytes:\n"
                           "        400  runtime\n        320  package demo\n         50  pyodide\n"
                           "          5  lists"}));
}

TEST(SizeBudget, NamesWhatGrewTheMostFirst) {
  const PartSizes before{
      {"lists", 7}, {"package demo", 100}, {"package gone", 9}, {"runtime", 390}};
  const auto over = over_budget(total(700), small_plan(), before);
  ASSERT_TRUE(over);
  EXPECT_EQ(over->why, (std::vector<std::string>{
                           "what grew since ros2wasm.sizes was written, in bytes (was, is):\n"
                           "        100        320       +220  package demo\n"
                           "          0         50        +50  pyodide\n"
                           "        390        400        +10  runtime"}));
  const auto same = over_budget(total(1), small_plan(), part_sizes(small_plan()));
  ASSERT_TRUE(same);
  EXPECT_EQ(same->why, std::vector<std::string>{
                           "nothing grew since ros2wasm.sizes was written: the budget is new"});
}

TEST(SizeBudget, ShowsTwelveParts) {
  std::map<std::string, std::size_t> files;
  for (int i = 10; i < 24; ++i) files["share/p" + std::to_string(i) + "/a"] = 10;
  const auto over = over_budget(total(1), plan_of(files), std::nullopt);
  ASSERT_TRUE(over);
  const std::string& table = over->why.front();
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 13);
  EXPECT_TRUE(table.ends_with("p21\nand 2 more")) << table;
}

TEST(SizeBudget, CompressedCountsWhatGzipSends) {
  const std::uint64_t size = compressed_size(small_plan());
  EXPECT_GT(size, 5U * 18);  // a frame for each file
  EXPECT_LT(size, 300U);
  SiteBudget budget = total(10'000);
  budget.compressed = Spanned<std::uint64_t>{.value = size, .span = {}};
  EXPECT_FALSE(over_budget(budget, small_plan(), std::nullopt));
  budget.compressed->value -= 1;
  const auto over = over_budget(budget, small_plan(), std::nullopt);
  ASSERT_TRUE(over);
  EXPECT_NE(over->message.find(" compressed, 1 B more"), std::string::npos) << over->message;
}

TEST(SizeBudget, LinesOfAMergeAreNoSizes) {
  const PartSizes wanted{{"a: b", 3}, {"runtime", 4}};
  EXPECT_EQ(read_sizes("<<<<<<< ours\nruntime: 4\n=======\nlists: -1\nlists: 5 kB\n>>>>>>> x\n"
                       "# c: 1\nlists: 99999999999999999999999\na: b: 3"),
            wanted);
}

}  // namespace
}  // namespace ros2wasm
