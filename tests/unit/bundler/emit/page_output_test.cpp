// A site as one page: what it carries comes out again, that the same plan gives the same bytes, and
// what is refused.
#include "bundler/emit/page_output.hpp"

#include <gtest/gtest.h>

#include "bundler/archive/deflate.hpp"
#include "bundler/emit/site_output.hpp"
#include "bundler/io/base64.hpp"
#include "bundler/io/files.hpp"
#include "bundler/render/carried_page.hpp"
#include "tests/unit/bundler/support/temporary_tree.hpp"

namespace ros2wasm {
namespace {
using testing::TemporaryTree;

constexpr const char* kBare = "<!doctype html>\n<html><body>\n<p></body></html>\n";

PlannedFile file(const std::string& path, const std::string& bytes) {
  return {.path = path, .reason = "test", .bytes = bytes, .sha256 = {}};
}

SitePlan plan_of(const std::string& page) {
  SitePlan plan;
  plan.files = {file("a \"b\" <&>.txt", page), file("programs/a.wasm", std::string(3000, '\0')),
                file("site.json", R"({"generator": "ros2wasm 0.1.0"})")};
  plan.carried_page = kBare;
  plan.sha256 = std::string(64, 'a');
  return plan;
}

TEST(EmitPage, WhatItCarriesComesOutAgain) {
  const TemporaryTree tree;
  ASSERT_TRUE(emit_site(plan_of("<p>"), tree / "deep/one.html", {}));
  ASSERT_TRUE(emit_site(plan_of("<p>"), tree / "two.html", {}));
  const auto page = read_file(tree / "deep/one.html", kMostOfData);
  ASSERT_TRUE(page);
  EXPECT_EQ(*page, *read_file(tree / "two.html", kMostOfData));
  const auto carried = read_carried_page(*page, "one.html");
  ASSERT_TRUE(carried);
  EXPECT_EQ(carried->bare, kBare);
  ASSERT_EQ(carried->files.size(), 3U);
  EXPECT_EQ(carried->files[0].path, "site.json");
  EXPECT_EQ(carried->files[1].path, "a &quot;b&quot; &lt;&amp;&gt;.txt");
  EXPECT_EQ(*unpacked(carried->files[1], 3), "<p>");
  EXPECT_EQ(*unpacked(carried->files[2], 3000), std::string(3000, '\0'));
  EXPECT_EQ(unpacked(carried->files[2], 2999).errors()[0].code, "R2W0202");
}

TEST(EmitPage, ReplacesItsOwnPagesOnly) {
  const TemporaryTree tree;
  ASSERT_TRUE(emit_page(plan_of("one"), tree / "site.html", {}));
  ASSERT_TRUE(emit_page(plan_of("two"), tree / "site.html", {}));
  for (const std::string& other : {std::string(), std::string("<!doctype html>\n<p>a letter"),
                                   read_file(tree / "site.html", kMostOfData)->substr(0, 20)}) {
    ASSERT_TRUE(write_file(tree / "other.html", other));
    const auto emitted = emit_page(plan_of("x"), tree / "other.html", {});
    ASSERT_FALSE(emitted);
    EXPECT_EQ(emitted.errors()[0].code, "R2W0601");
    EXPECT_EQ(*read_file(tree / "other.html", kMostOfData), other);
  }
  ASSERT_TRUE(make_directories(tree / "folder.html"));
  EXPECT_EQ(refuse_output(tree / "folder.html")->code, "R2W0601");
  EXPECT_FALSE(refuse_output(tree / "new.html"));
}

TEST(EmitPage, WhatNoPageCanCarryIsSaid) {
  const TemporaryTree tree;
  SitePlan with_channel = plan_of("x");
  with_channel.channel = {{.path = "channel/noarch/a.json", .reason = "test", .bytes = "{}"}};
  SitePlan outside = plan_of("x");
  outside.files.push_back(file("../evil", "x"));
  EXPECT_EQ(emit_page(with_channel, tree / "a.html", {}).errors()[0].code, "R2W0609");
  EXPECT_EQ(emit_page(outside, tree / "a.html", {}).errors()[0].code, "R2W0608");
  EXPECT_FALSE(std::filesystem::exists(tree / "a.html"));
}

TEST(CarriedPage, APartOfItIsNotThePage) {
  const std::string page = carried_page(plan_of("x"));
  for (std::size_t size = 0; size + 1 < page.size(); ++size) {
    const auto read = read_carried_page(page.substr(0, size), "a.html");
    EXPECT_TRUE(!read || read->bare != kBare) << size;
  }
}

TEST(Deflate, IsReadBackAndBounded) {
  for (const std::string& text : {std::string(), std::string("a"), std::string(5'000'000, 'b')}) {
    const std::string small = deflated(text);
    EXPECT_EQ(*inflated(small, text.size(), "a"), text);
    EXPECT_FALSE(inflated(small.substr(0, small.size() - 1), text.size(), "a"));
    if (text.empty()) continue;
    EXPECT_FALSE(inflated(small, text.size() - 1, "a"));
  }
  EXPECT_FALSE(inflated("no deflate", 100, "a"));
}

TEST(Base64, IsReadBackAndStrict) {
  for (const char* text : {"", "f", "fo", "foo", "foob", "fooba", "foobar"})
    EXPECT_EQ(base64_read(base64(text)), text);
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  for (const char* text : {"Z", "Zg", "Zg=", "Zh==", "Zm9=", "====", "Zg==Zg==", "Zm 9", "Zm9\n"})
    EXPECT_FALSE(base64_read(text)) << text;
}

}  // namespace
}  // namespace ros2wasm
