// Match specs: the table of conda's answers, what is refused, and the parts that the table does not
// show.
#include "workspace_schema/conda/match_spec.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace ros2wasm {
namespace {

PackageRecord record(const std::string& version, const std::string& build) {
  PackageRecord made{.name = "pkg",
                     .version = version,
                     .build = build,
                     .subdir = "noarch",
                     .channel = "https://host/forge"};
  const std::size_t digits = build.find_last_not_of("0123456789") + 1;
  if (digits < build.size()) made.build_number = std::stoull(build.substr(digits));
  return made;
}

bool matches(const std::string& text, const PackageRecord& candidate) {
  const auto spec = MatchSpec::parse(text);
  EXPECT_TRUE(spec.ok()) << text;
  return spec.ok() && spec->matches(candidate);
}

TEST(MatchSpec, TableOfCondasAnswers) {
  std::ifstream table(std::string(ROS2WASM_SOURCE_DIR) +
                      "/tests/unit/workspace_schema/match_spec_table.tsv");
  ASSERT_TRUE(table.is_open());
  std::size_t rows = 0;
  for (std::string line; std::getline(table, line);) {
    if (line.starts_with("# ")) continue;
    std::istringstream columns(line);
    std::string spec, version, build, answer;
    std::getline(columns, spec, '\t');
    std::getline(columns, version, '\t');
    std::getline(columns, build, '\t');
    std::getline(columns, answer, '\t');
    EXPECT_EQ(matches(spec, record(version, build)), answer == "yes") << line;
    ++rows;
  }
  EXPECT_GE(rows, 300U);
}

TEST(MatchSpec, RefusesWhatIsNone) {
  for (const char* text : {"",
                           "pkg ==",
                           "pkg !=",
                           "pkg >=1.2,",
                           "pkg >=",
                           "pkg 1.2=",
                           "pkg ><1",
                           "pkg >=3.8<3.9",
                           "pkg !!1",
                           "pkg >==1",
                           "pkg 1.5||1.6",
                           "pkg[version='(1.5']",
                           "pkg[version='1.5)']",
                           "pkg 1..2",
                           "pkg[sha512=00]",
                           "pkg[build=]",
                           "chan:: pkg",
                           "p/kg",
                           "-pkg",
                           "pkg..x",
                           "pkg 1 [a=[b]]",
                           "pkg[version='~=1.*']",
                           "pkg[build='^(a$']",
                           "pkg[build='^a{3,2}$']",
                           "pkg[build='^((a{99}){99}){99}$']",
                           "pkg[build='^a)$']",
                           "pkg[build='^a**$']",
                           "pkg[build='^(|*)$']",
                           "pkg[build='^(a)\\1$']",
                           "pkg[build='^[a$']",
                           "pkg[build_number='>=1,<3']",
                           "pkg[build_number='^1']",
                           " pkg",
                           "pkg = ",
                           "pkg= ",
                           "__",
                           "___pkg",
                           "pkg 1.2)",
                           "pkg 1,(2",
                           "pkg[build='^(?=a)$']",
                           "pkg[build_number='>']"}) {
    const auto spec = MatchSpec::parse(text);
    ASSERT_FALSE(spec.ok()) << text;
    EXPECT_EQ(spec.errors().front().code.text(), "R2W0303") << text;
  }
}

// Guarantee, hostile input: versions and specs that nest or repeat without end are refused or
// matched soon
TEST(MatchSpec, HostileTextsEndSoon) {
  EXPECT_FALSE(MatchSpec::parse(std::string(1'000'000, '(')).ok());
  EXPECT_FALSE(VersionSpec::parse(std::string(4000, '(')).ok());
  std::string many = "1";
  for (int i = 0; i < 4000; ++i) many += "|1";
  EXPECT_TRUE(VersionSpec::parse(many)->matches(*Version::parse("1")));
  EXPECT_FALSE(VersionSpec::parse(many + many).ok());
  std::string nested;
  for (int i = 0; i < 600; ++i) nested += "(1,(2|";
  EXPECT_FALSE(VersionSpec::parse(nested).ok());
  EXPECT_TRUE(VersionSpec::parse(nested + "1" + std::string(1200, ')')).ok());
  const auto stars =
      TextPattern::parse("^" + std::string("(a*)*").append("(a*)*b") + "$", LetterCase::kCounts);
  ASSERT_TRUE(stars.ok());
  EXPECT_FALSE(stars->matches(std::string(2000, 'a')));
  EXPECT_FALSE(glob_matches("*a*a*a*a*a*a*a*b", std::string(5000, 'a')));
}

TEST(MatchSpec, RegularExpressionsArePythons) {
  const auto fits = [](const std::string& text, std::string_view value) {
    const auto pattern = TextPattern::parse(text, LetterCase::kCounts);
    EXPECT_TRUE(pattern.ok()) << text;
    return pattern.ok() && pattern->matches(value);
  };
  EXPECT_TRUE(fits(R"(^py3\d{1,2}_\w+$)", "py310_0"));
  EXPECT_FALSE(fits(R"(^py3\d{1,2}_\w+$)", "py3100_0"));
  EXPECT_TRUE(fits(R"(^[\d.]+$)", "1.2"));
  EXPECT_FALSE(fits(R"(^[\d.]+$)", "1.2]"));
  EXPECT_TRUE(fits("^[^]a-c]*$", "xyz"));
  EXPECT_FALSE(fits("^[^]a-c]*$", "xb"));
  EXPECT_TRUE(fits("^[-^]$", "^"));
  EXPECT_TRUE(fits("^[\\^\\-]$", "-"));
  EXPECT_FALSE(fits("^[\\^\\-]$", "a"));
  EXPECT_TRUE(fits("^(?:a|bc)+?$", "abca"));
  EXPECT_TRUE(fits("^a|b$", "ax"));  // from the beginning, as Python's `match`
  EXPECT_FALSE(fits("^a|b$", "xb"));
}

TEST(MatchSpec, WhatIsInBracketsIsReadInPlaceOfWhatStandsBefore) {
  EXPECT_TRUE(matches("pkg 1..2 x[version=2,build=*]", record("2", "y")));
  EXPECT_TRUE(matches("pkg[build_number=' +0_1']", record("2", "y_1")));
  EXPECT_FALSE(matches("pkg[build_number='1*']", record("2", "y_1")));
  EXPECT_TRUE(matches("pkg[build_number='^1.$']", record("2", "y_12")));
}

TEST(MatchSpec, SpacesBehindAComparisonMeanNothing) {
  EXPECT_TRUE(matches("pkg >= 1.2, < 2.0", record("1.5", "0")));
  EXPECT_FALSE(matches("pkg[version='>=1.2 , < 2.0']", record("2.5", "0")));
}

TEST(MatchSpec, ChannelSubdirAndHashes) {
  PackageRecord candidate = record("1.0", "h_0");
  candidate.sha256 = std::string(64, 'a');
  EXPECT_TRUE(matches("forge::pkg", candidate));
  EXPECT_TRUE(matches("https://host/forge::pkg", candidate));
  EXPECT_FALSE(matches("other::pkg", candidate));
  EXPECT_TRUE(matches("f*/noarch::pkg", candidate));
  EXPECT_FALSE(matches("forge/linux-64::pkg", candidate));
  EXPECT_TRUE(matches("forge/*::pkg", candidate));
  EXPECT_TRUE(matches("pkg[sha256=" + std::string(64, 'A') + "]", candidate));
  EXPECT_FALSE(matches("pkg[sha256=" + std::string(64, 'b') + ",build=*]", candidate));
  EXPECT_FALSE(matches("pkg[subdir=linux-64]", candidate));
  EXPECT_TRUE(matches("*[channel=forge]", candidate));
}

TEST(MatchSpec, FileNamesAndAddresses) {
  PackageRecord candidate = record("1.0", "h_0");
  candidate.file_name = "pkg-1.0-h_0.conda";
  candidate.url = "https://host/forge/noarch/pkg-1.0-h_0.conda";
  EXPECT_TRUE(matches("pkg-1.0-h_0.conda", candidate));
  EXPECT_TRUE(matches("https://host/forge/noarch/pkg-1.0-h_0.conda", candidate));
  EXPECT_FALSE(matches("https://other/forge/noarch/pkg-1.0-h_0.conda", candidate));
  EXPECT_EQ(MatchSpec::parse("https://host/forge/noarch/pkg-1.0-h_0.conda")->exact_name(), "pkg");
  EXPECT_FALSE(
      matches("https://host/forge/noarch/pkg-1.0-h_0.conda#" + std::string(32, 'a'), candidate));
}

TEST(MatchSpec, NamesAndPatterns) {
  EXPECT_EQ(MatchSpec::parse("SoMe-PkG")->exact_name(), "some-pkg");
  EXPECT_EQ(MatchSpec::parse("ros-*")->exact_name(), std::nullopt);
  EXPECT_EQ(MatchSpec::parse("__unix")->exact_name(), "__unix");
  EXPECT_TRUE(MatchSpec::parse("pkg *")->version().any());
  EXPECT_TRUE(MatchSpec::parse("_").ok());
  EXPECT_TRUE(MatchSpec::parse("_-x").ok());
}

}  // namespace
}  // namespace ros2wasm
