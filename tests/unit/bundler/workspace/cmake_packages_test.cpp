#include "bundler/workspace/cmake_packages.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

std::vector<std::string> names(std::string_view text) {
  std::vector<std::string> result;
  for (const auto& one : cmake_packages(text, "CMakeLists.txt")) result.push_back(one.value);
  return result;
}

TEST(CmakePackages, TellsNamesOnceInTheirOrder) {
  EXPECT_EQ(names("find_package(rclcpp REQUIRED)\n  FIND_PACKAGE ( std_msgs )\n"
                  "if(X) find_package(tf2) find_package(rclcpp)"),
            (std::vector<std::string>{"rclcpp", "std_msgs", "tf2"}));
}

TEST(CmakePackages, LeavesOutCommentsVariablesAndOtherCommands) {
  EXPECT_EQ(
      names("# find_package(a)\nmy_find_package(b)\nfind_package(${c})\nfind_package(${d}_msgs)\n"
            "find_package(e${f})\nfind_package(\nfind_package"),
      std::vector<std::string>());
}

TEST(CmakePackages, KnowsThePlace) {
  const auto found = cmake_packages("project(x)\n  find_package(demo REQUIRED)  # why\r\n", "a/b");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].span.file, "a/b");
  EXPECT_EQ(found[0].span.line, 2U);
  EXPECT_EQ(found[0].span.column, 16U);
  EXPECT_EQ(found[0].span.length, 4U);
}

}  // namespace
}  // namespace ros2wasm
