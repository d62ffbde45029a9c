// Whether packages are a solution, without an index.
#include <gtest/gtest.h>

#include "bundler/resolve/solve.hpp"
#include "unit/bundler/support/small_channel.hpp"

namespace ros2wasm {
namespace {

using testing::made_record;
using testing::request_for;

std::vector<std::string> faults(const std::vector<std::string>& specs,
                                const std::vector<PackageRecord>& packages) {
  std::vector<std::string> messages;
  for (const Diagnostic& fault : check_solution(request_for(specs).specs, packages)) {
    EXPECT_EQ(fault.code, "R2W0311");
    messages.push_back(fault.message);
  }
  return messages;
}

using Lines = std::vector<std::string>;

TEST(CheckSolution, EveryEdgeCounts) {
  PackageRecord a = made_record("a", "1", {"b >=1", "__unix"});
  a.constrains = {"c <2", "absent 1"};
  EXPECT_EQ(faults({"a"}, {a, made_record("b", "1")}), Lines{});
  EXPECT_EQ(faults({"a 2"}, {a, made_record("b", "1")}),
            Lines{"the workspace asks for `a 2`, but a 1 h_0 is there"});
  EXPECT_EQ(faults({"a"}, {a, made_record("b", "0.9")}),
            Lines{"a 1 needs `b >=1`, but b 0.9 h_0 is there"});
  EXPECT_EQ(faults({"a"}, {a}), Lines{"a 1 needs `b >=1`, but nothing like it is there"});
  EXPECT_EQ(faults({"a"}, {a, made_record("b", "1"), made_record("c", "2")}),
            Lines{"a 1 allows only `c <2`, but c 2 h_0 is there"});
  EXPECT_EQ(faults({}, {made_record("b", "1"), made_record("b", "2")}),
            Lines{"`b` is there twice"});
}

TEST(CheckSolution, NobodyIsInTheirOwnWay) {
  PackageRecord a = made_record("ros-a", "1");
  a.constrains = {"ros-* >=2"};
  EXPECT_EQ(testing::answer({"ros-a"}, {a}), "ros-a 1");
  EXPECT_EQ(faults({"ros-a"}, {a}), Lines{});
  EXPECT_EQ(testing::answer({"ros-a", "ros-b"}, {a, made_record("ros-b", "1")}), "R2W0301");
  EXPECT_EQ(faults({"ros-a"}, {a, made_record("ros-b", "1")}),
            Lines{"ros-a 1 allows only `ros-* >=2`, but ros-b 1 h_0 is there"});
}

TEST(CheckSolution, EverySolutionIsOne) {
  const RepoIndex index =
      testing::index_of({made_record("a", "1", {"b", "c >=1"}), made_record("b", "1", {"c <3"}),
                         made_record("c", "2"), made_record("c", "3")});
  const auto resolution = solve(request_for({"a"}), index);
  ASSERT_TRUE(resolution.ok());
  EXPECT_TRUE(check_solution(request_for({"a"}).specs, resolution->packages).empty());
}

}  // namespace
}  // namespace ros2wasm
