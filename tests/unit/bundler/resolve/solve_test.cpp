// Tests of the choice of the resolver, and of its messages when nothing fits.
#include "bundler/resolve/solve.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <random>
#include <thread>

#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

using testing::answer;
using testing::index_of;
using testing::made_record;
using testing::request_for;

TEST(Solve, NewestVersionThenHighestBuild) {
  EXPECT_EQ(answer({"a"}, {made_record("a", "1.9"), made_record("a", "1.10"),
                           made_record("a", "1.10", {}, 2), made_record("a", "1.10", {}, 1)}),
            "a 1.10 h_2");
  EXPECT_EQ(answer({"a <1.10"}, {made_record("a", "1.9"), made_record("a", "1.10")}), "a 1.9");
  EXPECT_EQ(answer({"a"}, {made_record("a", "2.0rc1"), made_record("a", "1.0")}), "a 2.0rc1");
}

TEST(Solve, OnlyWhatIsNeededInInstallOrder) {
  EXPECT_EQ(answer({"z", "m"},
                   {made_record("z", "1", {"b", "y"}), made_record("b", "1", {"y"}),
                    made_record("y", "1"), made_record("m", "1"), made_record("unused", "1")}),
            "y 1, b 1, m 1, z 1");
  EXPECT_EQ(answer({"a"}, {made_record("a", "1", {"b"}), made_record("b", "1", {"a"})}),
            "b 1, a 1");  // a cycle
}

TEST(Solve, GoesBackWhereTheNewestDoesNotFit) {
  EXPECT_EQ(answer({"a", "b <2"}, {made_record("a", "2", {"b >=2"}), made_record("a", "1", {"b"}),
                                   made_record("b", "1"), made_record("b", "2")}),
            "b 1, a 1");
  // Deep: the only way out is three steps down.
  EXPECT_EQ(answer({"a", "d 1"}, {made_record("a", "2", {"b 2"}), made_record("a", "1", {"b 1"}),
                                  made_record("b", "2", {"c 2"}), made_record("b", "1", {"c"}),
                                  made_record("c", "2", {"d 2"}), made_record("c", "1", {"d"}),
                                  made_record("d", "1"), made_record("d", "2")}),
            "d 1, c 1, b 1, a 1");
}

TEST(Solve, ConstrainsHoldOnlyIfThePackageIsThere) {
  PackageRecord a = made_record("a", "1");
  a.constrains = {"b <2"};
  const std::vector<PackageRecord> records{a, made_record("b", "1"), made_record("b", "2"),
                                           made_record("c", "1", {"b"})};
  EXPECT_EQ(answer({"a"}, records), "a 1");
  EXPECT_EQ(answer({"a", "c"}, records), "a 1, b 1, c 1");
  EXPECT_EQ(answer({"a", "b 2"}, records), "R2W0301");
}

TEST(Solve, VirtualPackagesOfThePlatform) {
  EXPECT_EQ(answer({"a"}, {made_record("a", "1", {"__unix", "__archspec * wasm32"})}), "a 1");
  EXPECT_EQ(answer({"a"}, {made_record("a", "2", {"__linux"}), made_record("a", "1")}), "a 1");
  PackageRecord a = made_record("a", "1");
  a.constrains = {"__unix >=1"};
  EXPECT_EQ(answer({"a"}, {a}), "R2W0301");
  a.constrains = {"__glibc >=2"};
  EXPECT_EQ(answer({"a"}, {a}), "a 1");
}

TEST(Solve, TrackFeaturesAreAvoided) {
  PackageRecord heavy = made_record("a", "2");
  heavy.track_features = {"debug"};
  EXPECT_EQ(answer({"a"}, {heavy, made_record("a", "1")}), "a 1");
}

TEST(Solve, ChannelPriorities) {
  PackageRecord low = made_record("a", "2");
  low.channel = "second";
  low.url = "second/noarch/" + low.file_name;
  RepoIndex index = index_of({made_record("a", "1"), low});
  index.channels = {"test", "second"};
  ResolveRequest request = request_for({"a"});
  EXPECT_EQ(answer(request, index), "a 1");
  request.priority = ChannelPriority::kDisabled;
  EXPECT_EQ(answer(request, index), "a 2");
  request.priority = ChannelPriority::kFlexible;
  EXPECT_EQ(answer(request, index), "a 1");
  request.specs[0].text = "a >=2";
  EXPECT_EQ(answer(request, index), "a 2");
  request.priority = ChannelPriority::kStrict;
  EXPECT_EQ(answer(request, index), "R2W0301");
  // A request that names the channel goes before the order of channels.
  request.specs[0].text = "second::a";
  EXPECT_EQ(answer(request, index), "a 2");
  request.specs[0].text = "third::a";
  EXPECT_EQ(answer(request, index), "R2W0301");
}

TEST(Solve, LockedPackagesAreKeptWhileTheyFit) {
  const RepoIndex index = index_of(
      {made_record("a", "1"), made_record("a", "2"), made_record("b", "1"), made_record("b", "2")});
  ResolveRequest request = request_for({"a", "b"});
  request.locked = {made_record("a", "1")};
  EXPECT_EQ(answer(request, index), "a 1, b 2");
  request.specs[0].text = "a >=2";
  EXPECT_EQ(answer(request, index), "a 2, b 2");
}

TEST(Solve, PatternsForNames) {
  EXPECT_EQ(answer({"ros-*-b 1"}, {made_record("ros-x-b", "1"), made_record("other", "1")}),
            "ros-x-b 1");
}

TEST(Solve, TheOrderOfRecordsAndSpecsDoesNotMatter) {
  std::vector<PackageRecord> records;
  for (int i = 0; i < 12; ++i) {
    for (int version = 1; version <= 4; ++version) {
      std::vector<std::string> depends;
      if (i > 0)
        depends.push_back("p" + std::to_string(i - 1) + " >=" + std::to_string(version - 1));
      if (i > 3)
        depends.push_back("p" + std::to_string(i - 3) + " <" + std::to_string(version + 2));
      for (std::uint64_t build = 0; build < 2; ++build) {
        PackageRecord record =
            made_record("p" + std::to_string(i), std::to_string(version), depends, build);
        record.build = "x" + record.build;
        record.build_number = 0;  // only the file name tells them apart
        record.file_name = record.name + "-" + record.version + "-" + record.build + ".conda";
        record.url = "test/noarch/" + record.file_name;
        records.push_back(record);
      }
    }
  }
  std::vector<std::string> specs{"p11", "p7 <4", "p2"};
  const auto first = solve(request_for(specs), index_of(records));
  ASSERT_TRUE(first.ok());
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    std::shuffle(records.begin(), records.end(), random);
    std::shuffle(specs.begin(), specs.end(), random);
    const auto again = solve(request_for(specs), index_of(records));
    ASSERT_TRUE(again.ok());
    ASSERT_EQ(again->packages, first->packages);
  }
}

Diagnostic error_of(const ResolveRequest& request, const RepoIndex& index) {
  const auto resolution = solve(request, index);
  EXPECT_FALSE(resolution.ok());
  return resolution.ok() ? Diagnostic{} : resolution.errors().front();
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

TEST(SolveErrors, ConflictIsExplainedAsATree) {
  const RepoIndex index = index_of(
      {made_record("nav", "1.0", {"core >=2", "maps"}), made_record("nav", "0.9", {"core >=2"}),
       made_record("maps", "1"), made_record("arm", "3.0", {"core <2"}), made_record("core", "1.0"),
       made_record("core", "2.0")});
  ResolveRequest request = request_for({"nav", "arm"});
  request.specs[0].origin = "package.xml of demo";
  request.specs[1].span =
      SourceSpan{.file = "workspace.yaml", .line = 4, .column = 5, .length = 3, .line_text = {}};
  const Diagnostic error = error_of(request, index);
  EXPECT_EQ(error.code, "R2W0301");
  EXPECT_EQ(joined(error.why), R"(`nav` is asked for by package.xml of demo
  nav 1.0, 0.9 needs `core >=2`
    core 2.0 cannot be there together with another version of core
`arm` is asked for at workspace.yaml:4:5
  arm 3.0 needs `core <2`
    core 1.0 cannot be there together with another version of core
)");
  EXPECT_EQ(error.span->line, 4U);
  EXPECT_TRUE(error.fix.empty());
}

TEST(SolveErrors, WhatIsThereInstead) {
  const Diagnostic error = error_of(
      request_for({"a"}),
      index_of({made_record("a", "1", {"b >=3"}), made_record("b", "1"), made_record("b", "2")}));
  EXPECT_EQ(joined(error.why), R"(`a` is asked for
  a 1 needs `b >=3`, but there is only b 2, 1
)");
}

TEST(SolveErrors, AnAbiThatDisagreesIsNamed) {
  const Diagnostic error = error_of(
      request_for({"a", "b"}),
      index_of({made_record("a", "1", {"emscripten-abi 3.1.6.*"}),
                made_record("b", "1", {"emscripten-abi 4.0.9.*"}),
                made_record("emscripten-abi", "3.1.6"), made_record("emscripten-abi", "4.0.9")}));
  EXPECT_EQ(error.code, "R2W0301");
  EXPECT_EQ(
      error.why.back(),
      "what different versions of Emscripten built (emscripten-abi) cannot run in one program");
}

TEST(SolveErrors, RecordsWithUnreadableSpecsAreNotTakenAndNamed) {
  const PackageRecord bad = made_record("a", "2", {"ray[default"});
  const auto resolution = solve(request_for({"a"}), index_of({bad, made_record("a", "1")}));
  ASSERT_TRUE(resolution.ok());
  EXPECT_EQ(resolution->packages.at(0).version, "1");
  ASSERT_EQ(resolution->left_out.size(), 1U);
  EXPECT_EQ(resolution->left_out[0].file_name, bad.file_name);
  const Diagnostic error = error_of(request_for({"a"}), index_of({bad}));
  EXPECT_NE(error.why.back().find("was skipped"), std::string::npos);
}

TEST(SolveErrors, AFixIsOfferedOnlyWhenItSolves) {
  const RepoIndex index = index_of({made_record("a", "1"), made_record("b", "1", {"missing"})});
  EXPECT_EQ(error_of(request_for({"a >=2"}), index).fix,
            std::vector<std::string>{"write `a 1` instead of `a >=2`"});
  EXPECT_TRUE(error_of(request_for({"b >=2"}), index).fix.empty());
}

TEST(SolveErrors, AllUnknownNamesAtOnceWithTheNearest) {
  RepoIndex index = index_of({made_record("ros-jazzy-rclcpp", "28.1.9")});
  index.left_out.push_back({.channel = "test",
                            .subdir = "noarch",
                            .file_name = "broken-1-0.conda",
                            .reason = "its version is bad"});
  const auto resolution =
      solve(request_for({"ros-jazzy-rclcp", "broken", "ros-jazzy-rclcpp"}), index);
  ASSERT_FALSE(resolution.ok());
  ASSERT_EQ(resolution.errors().size(), 2U);
  EXPECT_EQ(resolution.errors()[0].code, "R2W0302");
  EXPECT_EQ(resolution.errors()[0].fix, std::vector<std::string>{"write `ros-jazzy-rclcpp`"});
  EXPECT_EQ(resolution.errors()[1].why.back(), "broken-1-0.conda was skipped: its version is bad");
}

TEST(SolveErrors, AllBadSpecsAtOnce) {
  const auto resolution =
      solve(request_for({"a >=", "a", "b ==="}), index_of({made_record("a", "1")}));
  ASSERT_FALSE(resolution.ok());
  EXPECT_EQ(resolution.errors().size(), 2U);
  EXPECT_EQ(resolution.errors()[0].code, "R2W0303");
}

TEST(SolveErrors, APackageOfAChannelIsNotThereOfItself) {
  // Two underscores in front make no package of the platform.
  const RepoIndex index =
      index_of({made_record("__foo", "1", {"missing"}), made_record("lib", "1", {"other"})});
  const auto resolution = solve(request_for({"lib"}), index);
  ASSERT_FALSE(resolution.ok());
  ASSERT_EQ(resolution.errors().size(), 1U);
  for (const std::string& line : resolution.errors().front().why)
    EXPECT_EQ(line.find("missing"), std::string::npos) << line;
}

/// One name more than there are versions, and no two may have the same: it takes very many dead
/// ends to know that this cannot be.
std::vector<PackageRecord> pigeons(int holes) {
  std::vector<PackageRecord> records{made_record("all", "1")};
  for (int name = 0; name <= holes; ++name) {
    records.front().depends.push_back("p" + std::to_string(name));
    for (int version = 1; version <= holes; ++version) {
      const std::string number = std::to_string(version);
      PackageRecord record = made_record("p" + std::to_string(name), number);
      for (int other = 0; other <= holes; ++other) {
        if (other != name)
          record.constrains.push_back("p" + std::to_string(other) + " !=" + number);
      }
      records.push_back(std::move(record));
    }
  }
  return records;
}

TEST(Solve, GivesUpAfterSoManyDeadEnds) {
  const SearchBudget budget{.cancellation = {}, .most_contradictions = 2000};
  const auto small = solve(request_for({"all"}), index_of(pigeons(4)), budget);
  ASSERT_FALSE(small.ok());
  EXPECT_EQ(small.errors().front().code.text(), "R2W0301");
  const auto large = solve(request_for({"all"}), index_of(pigeons(12)), budget);
  ASSERT_FALSE(large.ok());
  const Diagnostic& error = large.errors().front();
  EXPECT_EQ(error.code, "R2W0305");
  ASSERT_EQ(error.why.size(), 2U);
  EXPECT_NE(error.why[0].find("2000 dead ends"), std::string::npos);
  EXPECT_NE(error.why[1].find(" p"), std::string::npos) << error.why[1];
}

TEST(Solve, StopsWhenItIsAskedTo) {
  std::atomic<bool> flag = false;
  const SearchBudget budget{.cancellation = Cancellation(flag),
                            .most_contradictions = std::numeric_limits<std::size_t>::max()};
  std::thread asks([&flag] { flag = true; });
  const auto answer = solve(request_for({"all"}), index_of(pigeons(12)), budget);
  asks.join();
  ASSERT_FALSE(answer.ok());
  EXPECT_EQ(answer.errors().front().code.text(), "R2W0903");
}

TEST(Solve, WhatWasForgottenIsLearntAgain) {
  // Thousands of dead ends, most of them forgotten on the way, and the answer is still the proof.
  EXPECT_EQ(answer({"all"}, pigeons(7)), "R2W0301");
  std::vector<PackageRecord> records = pigeons(7);
  records.push_back(made_record("all", "0", {"p0", "p1"}));
  EXPECT_EQ(answer({"all"}, records), "p0 7, p1 6, all 0");
}

}  // namespace
}  // namespace ros2wasm
