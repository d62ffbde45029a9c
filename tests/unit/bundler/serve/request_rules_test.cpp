// Paths that leave the site, hosts that are not ours, conditions and ranges.
#include "bundler/serve/request_rules.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(Loopback, InAnySpelling) {
  for (const char* host : {"localhost", "LOCALHOST", "127.0.0.1", "127.3.2.1", "127.1",
                           "2130706433", "0x7f.1", "::1", "0:0:0:0:0:0:0:1", "::ffff:127.0.0.1"})
    EXPECT_TRUE(is_loopback(host)) << host;
  for (const char* host : {"0.0.0.0", "::", "", "192.168.0.1", "127.0.0.1.example.org",
                           "example.org", "::ffff:192.168.0.1", "2130706434567"})
    EXPECT_FALSE(is_loopback(host)) << host;
}

TEST(SitePathOf, DecodesAndDropsTheQuery) {
  EXPECT_EQ(site_path_of("/"), "");
  EXPECT_EQ(site_path_of("/index.html"), "index.html");
  EXPECT_EQ(site_path_of("/programs/demo/talker.wasm?v=1#x"), "programs/demo/talker.wasm");
  EXPECT_EQ(site_path_of("/a%20b/%C3%BC.json"), "a b/\xC3\xBC.json");
  EXPECT_EQ(site_path_of("/docs/"), "docs/");
  EXPECT_EQ(site_path_of("/..a/b.."), "..a/b..");
}

TEST(SitePathOf, RefusesWhatCouldLeaveTheSite) {
  for (const char* target :
       {"",       "index.html", "http://other/x", "/..",     "/../etc/passwd", "/a/../b",
        "/./a",   "/%2e%2e/a",  "/%2E%2E/a",      "/.%2e/a", "/a%2fb",         "/a%2F..%2Fb",
        "/a%5cb", "/a\\b",      "//etc/passwd",   "/a//b",   "/a%00.html",     "/a%0d%0ab",
        "/%",     "/%4",        "/%zz",           "/a%"}) {
    EXPECT_EQ(site_path_of(target), std::nullopt) << target;
  }
}

TEST(IsLocalHost, TakesThisMachineOnly) {
  for (const char* host : {"localhost", "localhost:8000", "LOCALHOST", "app.localhost:1",
                           "127.0.0.1", "127.0.0.1:8000", "192.168.1.7:80", "[::1]:8000"}) {
    EXPECT_TRUE(is_local_host(host)) << host;
  }
  for (const char* host : {"", "evil.example", "localhost.evil.example:8000", "notlocalhost",
                           "127.0.0.1.evil.example", "1.2.3"}) {
    EXPECT_FALSE(is_local_host(host)) << host;
  }
}

TEST(MatchesEtag, ReadsLists) {
  EXPECT_TRUE(matches_etag("\"a\"", "\"a\""));
  EXPECT_TRUE(matches_etag("\"x\", W/\"a\"", "\"a\""));
  EXPECT_TRUE(matches_etag("*", "\"a\""));
  EXPECT_FALSE(matches_etag("\"ab\"", "\"a\""));
  EXPECT_FALSE(matches_etag("", "\"a\""));
  EXPECT_FALSE(matches_etag(",,", "\"a\""));
}

void expect_part(std::string_view header, std::uint64_t first, std::uint64_t length) {
  const RangeResult result = range_of(header, 100);
  EXPECT_EQ(result.answer, RangeAnswer::kPart) << header;
  EXPECT_EQ(result.range.first, first) << header;
  EXPECT_EQ(result.range.length, length) << header;
}

TEST(RangeOf, CutsInsideTheFile) {
  expect_part("bytes=0-9", 0, 10);
  expect_part("bytes=90-", 90, 10);
  expect_part("bytes=-5", 95, 5);
  expect_part("bytes=-500", 0, 100);
  expect_part("bytes=99-1000000", 99, 1);
  expect_part(" bytes=0-0 ", 0, 1);
}

TEST(RangeOf, KnowsWhatIsNotThere) {
  EXPECT_EQ(range_of("bytes=100-", 100).answer, RangeAnswer::kUnsatisfiable);
  EXPECT_EQ(range_of("bytes=-0", 100).answer, RangeAnswer::kUnsatisfiable);
  EXPECT_EQ(range_of("bytes=0-", 0).answer, RangeAnswer::kUnsatisfiable);
}

TEST(RangeOf, GivesTheWholeForTheRest) {
  for (const char* header :
       {"", "bytes", "bytes=", "bytes=-", "bytes=a-b", "bytes=1-2,4-5", "items=0-1", "bytes=9-3",
        "bytes=-1-2", "bytes=99999999999999999999-"}) {
    EXPECT_EQ(range_of(header, 100).answer, RangeAnswer::kWhole) << header;
  }
}

}  // namespace
}  // namespace ros2wasm
