// Versions: order, prefixes, and what is none.
#include "workspace_schema/conda/version.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

Version version(std::string_view text) {
  auto parsed = Version::parse(text);
  EXPECT_TRUE(parsed.ok()) << text;
  return parsed.ok() ? std::move(*parsed) : Version();
}

TEST(Version, IsOrderedAsCondaOrders) {
  // Groups of equal versions, each group newer than the one before (CEP 33, with openssl's and PEP
  // 440's forms).
  const std::vector<std::vector<std::string>> groups{{"0.4", "0.4.0"},
                                                     {"0.4.1.rc"},
                                                     {"0.4.1"},
                                                     {"0.5*"},
                                                     {"0.5a1"},
                                                     {"0.5b3"},
                                                     {"0.5C1"},
                                                     {"0.5"},
                                                     {"0.9.6"},
                                                     {"0.960923"},
                                                     {"1.0"},
                                                     {"1.0.1dev"},
                                                     {"1.0.1_"},
                                                     {"1.0.1a"},
                                                     {"1.0.1"},
                                                     {"1.0.1post.a"},
                                                     {"1.0.1post.z"},
                                                     {"1.0.1post"},
                                                     {"1.0.2"},
                                                     {"1.1dev1"},
                                                     {"1.1_"},
                                                     {"1.1a1"},
                                                     {"1.1.0dev1", "1.1.dev1"},
                                                     {"1.1.a1"},
                                                     {"1.1.0rc1", "1.1.rc1"},
                                                     {"1.1", "1.1.0"},
                                                     {"1.1.0post1", "1.1.post1"},
                                                     {"1.1post1"},
                                                     {"1.10000000000000000000"},
                                                     {"1.10000000000000000001"},
                                                     {"1996.07.12"},
                                                     {"1!0.4.1"},
                                                     {"1!3.1.1.6"},
                                                     {"2!0.4.1"}};
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (const std::string& a : groups[i]) {
      for (const std::string& b : groups[i]) EXPECT_EQ(version(a), version(b)) << a << " " << b;
      for (std::size_t j = i + 1; j < groups.size(); ++j) {
        for (const std::string& b : groups[j]) EXPECT_LT(version(a), version(b)) << a << " " << b;
      }
    }
  }
}

TEST(Version, LocalPartCountsLast) {
  EXPECT_LT(version("1.2"), version("1.2+1"));
  EXPECT_EQ(version("1.2+1"), version("1.2.0+1.0"));
  EXPECT_LT(version("1.2+9"), version("1.2.1"));
}

TEST(Version, BeginsWithAPrefix) {
  EXPECT_TRUE(version("1.8.3").starts_with(version("1.8")));
  EXPECT_TRUE(version("1.8alpha").starts_with(version("1.8")));
  EXPECT_TRUE(version("1.8").starts_with(version("1.8.0")));
  EXPECT_FALSE(version("1.80").starts_with(version("1.8")));
  EXPECT_TRUE(version("1.2+3.4").starts_with(version("1.2+3")));
  EXPECT_FALSE(version("1.3+3").starts_with(version("1.2+3")));
  EXPECT_TRUE(version("1.0rc2").starts_with(version("1.0r")));
}

TEST(Version, RefusesWhatIsNone) {
  for (const char* text : {"", " ", "1..2", ".1", "1.", "a!1", "1!2!3", "1+2+3", "+1", "1 2",
                           "1-2_3", "1.2~3", "5.\xC3\xA4", "1.2+"}) {
    const auto parsed = Version::parse(text);
    ASSERT_FALSE(parsed.ok()) << text;
    EXPECT_EQ(parsed.errors().front().code.text(), "R2W0304");
  }
  EXPECT_FALSE(Version::parse(std::string(100'000, '1')).ok());
}

TEST(Version, WhiteSpaceAroundItMeansNothing) {
  EXPECT_EQ(version("\x1c 1.2\t\v").text(), "1.2");
  EXPECT_EQ(version("\xC2\xA0"
                    "1.2\xE3\x80\x80\xE2\x80\x83")
                .text(),
            "1.2");
  EXPECT_FALSE(Version::parse("\xE2\x80\x83").ok());
}

TEST(Version, NumbersHaveAsManyDigitsAsPythonReads) {
  EXPECT_TRUE(Version::parse(std::string(4300, '9')).ok());
  EXPECT_FALSE(Version::parse("1." + std::string(4301, '9')).ok());
  EXPECT_FALSE(Version::parse("1+" + std::string(4301, '9')).ok());
}

TEST(Version, JsonIsCondasNestedList) {
  EXPECT_EQ(version_json(version("1!2.0rc1_").segments()), R"([[1],[2],[0,"rc",1,"_"]])");
  EXPECT_EQ(version_json(version("1.dev.post2").segments()), R"([[0],[1],[0,"DEV"],[0,1e999,2]])");
  EXPECT_EQ(version_json(version("007").segments()), "[[0],[7]]");
}

}  // namespace
}  // namespace ros2wasm
