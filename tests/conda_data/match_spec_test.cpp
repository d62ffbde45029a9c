// Match specs that conda accepts, and some that it rejects, from public lists.
#include "workspace_schema/conda/match_spec.hpp"

#include <sstream>
#include <vector>

#include "conda_data/conda_data.hpp"

namespace ros2wasm {
namespace {

std::vector<std::string> lines_of(const std::string& name) {
  std::istringstream stream(testing::conda_text("matchspec/" + name));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  }
  return lines;
}

TEST(PublicMatchSpecs, WhatCondaAcceptsIsAccepted) {
  const auto lines = lines_of("xpass.txt");
  EXPECT_GT(lines.size(), 100U);
  for (const std::string& line : lines) EXPECT_TRUE(MatchSpec::parse(line).ok()) << line;
}

TEST(PublicMatchSpecs, WhatCondaRejectsIsRejected) {
  const auto lines = lines_of("xfail.txt");
  EXPECT_GT(lines.size(), 15U);
  for (const std::string& line : lines) EXPECT_FALSE(MatchSpec::parse(line).ok()) << line;
}

TEST(PublicMatchSpecs, WhatCondaShouldNotRejectIsAccepted) {
  const auto lines = lines_of("xfail-should-pass.txt");
  EXPECT_FALSE(lines.empty());
  for (const std::string& line : lines) EXPECT_TRUE(MatchSpec::parse(line).ok()) << line;
}

}  // namespace
}  // namespace ros2wasm
