// A site as one archive: members and order, that the same plan gives the same bytes, and what is
// refused.
#include "bundler/emit/zip_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bundler/emit/site_output.hpp"
#include "bundler/io/files.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
using testing::TemporaryTree;

PlannedFile file(const std::string& path, const std::string& bytes) {
  return {.path = path, .reason = "test", .bytes = bytes, .sha256 = {}};
}

SitePlan plan_of(const std::string& page) {
  SitePlan plan;
  plan.files = {file("index.html", page), file("programs/a.wasm", "module"),
                file("site.json", R"({"generator": "ros2wasm 0.1.0"})")};
  plan.channel = {{.path = "channel/noarch/a.json", .reason = "test", .bytes = "{}", .size = 2}};
  return plan;
}

/// Where each name stands in the archive.
std::vector<std::size_t> places(const std::string& archive, const std::vector<std::string>& names) {
  std::vector<std::size_t> found;
  for (const std::string& name : names) found.push_back(archive.find(name));
  return found;
}

TEST(EmitZip, SiteJsonIsFirstAndTheSamePlanGivesTheSameBytes) {
  const TemporaryTree tree;
  ASSERT_TRUE(emit_site(plan_of("<p>"), tree / "deep/one.zip", {}));
  ASSERT_TRUE(emit_site(plan_of("<p>"), tree / "two.zip", {}));
  const auto one = read_file(tree / "deep/one.zip", kMostOfData);
  ASSERT_TRUE(one);
  EXPECT_EQ(*one, *read_file(tree / "two.zip", kMostOfData));
  const auto at =
      places(*one, {"site.json", "index.html", "programs/a.wasm", "channel/noarch/a.json"});
  EXPECT_TRUE(std::is_sorted(at.begin(), at.end()));
  EXPECT_EQ(at[0], 30U);
  EXPECT_NE(at[3], std::string::npos);
}

TEST(EmitZip, ReplacesItsOwnArchivesOnly) {
  const TemporaryTree tree;
  const auto site = tree / "site.zip";
  ASSERT_TRUE(emit_zip(plan_of("<p>one"), site, {}));
  ASSERT_TRUE(emit_zip(plan_of("<p>two"), site, {}));
  EXPECT_NE(read_file(site, kMostOfData)->find("<p>two"), std::string::npos);
  const std::string whole = *read_file(site, kMostOfData);
  for (const std::string& other :
       {std::string("PK"), std::string("a letter"), std::string(), whole.substr(0, 45),
        "PK\3\4" + whole.substr(4, 22) + std::string("\xff\xff", 2) + whole.substr(28)}) {
    ASSERT_TRUE(write_file(tree / "other.zip", other));
    const auto emitted = emit_zip(plan_of("<p>"), tree / "other.zip", {});
    ASSERT_FALSE(emitted);
    EXPECT_EQ(emitted.errors()[0].code, "R2W0601");
    EXPECT_EQ(*read_file(tree / "other.zip", kMostOfData), other);
  }
  ASSERT_TRUE(make_directories(tree / "folder.zip"));
  EXPECT_EQ(refuse_output(tree / "folder.zip")->code, "R2W0601");
  EXPECT_FALSE(refuse_output(tree / "new.zip"));
}

TEST(EmitZip, NothingLeadsOutOfTheArchive) {
  const TemporaryTree tree;
  SitePlan plan = plan_of("<p>");
  plan.files.push_back(file("../evil", "x"));
  const auto emitted = emit_zip(plan, tree / "site.zip", {});
  ASSERT_FALSE(emitted);
  EXPECT_EQ(emitted.errors()[0].code, "R2W0608");
  EXPECT_FALSE(std::filesystem::exists(tree / "site.zip"));
}

TEST(EmitZip, WhatDoesNotFitIsSaid) {
  const TemporaryTree tree;
  SitePlan large = plan_of("<p>");
  large.channel[0].size = 5'000'000'000;
  SitePlan many = plan_of("<p>");
  many.files.resize(70'000);
  for (const SitePlan& plan : {large, many}) {
    const auto emitted = emit_zip(plan, tree / "site.zip", {});
    ASSERT_FALSE(emitted);
    EXPECT_EQ(emitted.errors()[0].code, "R2W0609");
  }
  EXPECT_FALSE(std::filesystem::exists(tree / "site.zip"));
}

}  // namespace
}  // namespace ros2wasm
