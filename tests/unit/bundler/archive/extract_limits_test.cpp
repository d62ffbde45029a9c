// Limits of archives as people write them.
#include "bundler/archive/extract_limits.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(ExtractLimits, AreRead) {
  const auto limits = read_extract_limits("size=16G,members=7,ratio=300");
  ASSERT_TRUE(limits.ok());
  EXPECT_EQ(limits->total_bytes, 16ULL << 30U);
  EXPECT_EQ(limits->members, 7U);
  EXPECT_EQ(limits->ratio, 300U);
  EXPECT_EQ(read_extract_limits("size=5")->total_bytes, 5U);
  EXPECT_EQ(read_extract_limits("size=5K")->total_bytes, 5U << 10U);
  EXPECT_EQ(read_extract_limits("size=5M")->total_bytes, 5U << 20U);
}

TEST(ExtractLimits, WhatIsNotSaidKeepsItsDefault) {
  const ExtractLimits usual;
  for (const char* text : {"", "ratio=9"}) {
    const auto limits = read_extract_limits(text);
    ASSERT_TRUE(limits.ok()) << text;
    EXPECT_EQ(limits->total_bytes, usual.total_bytes);
    EXPECT_EQ(limits->members, usual.members);
  }
}

TEST(ExtractLimits, OtherTextsAreRefused) {
  for (const char* text :
       {"size", "size=", "size=0", "size=-1", "size=1.5G", "size=8T", "size=8GG", "ratio=2K",
        "members=x", "ratio=1,ratio=2", "files=3", "=3", ",", "size=1,,ratio=2",
        "size=18446744073709551616", "size=99999999999999G", " size=1"}) {
    const auto limits = read_extract_limits(text);
    ASSERT_FALSE(limits.ok()) << text;
    EXPECT_EQ(limits.errors().front().code.text(), "R2W0241") << text;
  }
  EXPECT_EQ(read_extract_limits("member=3").errors().front().fix,
            std::vector<std::string>{"write `members=3`"});
}

TEST(ExtractMeter, StopsAtTheLimit) {
  const ExtractLimits limits{.total_bytes = 100, .members = 2, .ratio = 5, .ratio_from_bytes = 10};
  const std::string name = "x";
  ExtractMeter sizes(limits, name, 1000);
  EXPECT_TRUE(sizes.bytes(100).ok());
  EXPECT_EQ(sizes.bytes(1).errors().front().code.text(), "R2W0225");
  ExtractMeter ratios(limits, name, 2);
  EXPECT_TRUE(ratios.bytes(10).ok());
  EXPECT_EQ(ratios.bytes(5).errors().front().code.text(), "R2W0225");
  ExtractMeter members(limits, name, 1000);
  EXPECT_TRUE(members.member().ok());
  EXPECT_TRUE(members.member().ok());
  EXPECT_EQ(members.member().errors().front().code.text(), "R2W0225");
}

}  // namespace
}  // namespace ros2wasm
