#include "bundler/workspace/cmake_packages.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace ros2wasm {
namespace {

std::vector<std::string> names(std::string_view text) {
  std::vector<std::string> result;
  for (const auto& one : cmake_packages(text, "CMakeLists.txt")) result.push_back(one.value);
  return result;
}

TEST(CmakePackages, TellsNamesOnceInTheirOrder) {
  EXPECT_EQ(names("find_package(rclcpp REQUIRED)\n  FIND_PACKAGE (\n  std_msgs\n  REQUIRED )\n"
                  "find_package(tf2 0.1 REQUIRED COMPONENTS a) find_package(rclcpp REQUIRED)"),
            (std::vector<std::string>{"rclcpp", "std_msgs", "tf2"}));
}

TEST(CmakePackages, LeavesOutWhatMayBeAbsent) {
  EXPECT_EQ(
      names("find_package(a)\nfind_package(b QUIET)\nif(BUILD_TESTING)\n"
            "  if(X)\n endif()\n find_package(c REQUIRED)\nendif()\nfind_package(d REQUIRED)"),
      std::vector<std::string>{"d"});
}

TEST(CmakePackages, TakesWhatLaterCommandsNeed) {
  EXPECT_EQ(names("find_package(a)\nfind_package(b)\nfind_package(c QUIET)\nset(DEPS b)\n"
                  "rosidl_generate_interfaces(${PROJECT_NAME} \"srv/A.srv\" DEPENDENCIES a)\n"
                  "ament_target_dependencies(node PUBLIC ${DEPS})"),
            (std::vector<std::string>{"a", "b"}));
}

TEST(CmakePackages, LeavesOutCommentsVariablesAndOtherCommands) {
  EXPECT_EQ(names("# find_package(a REQUIRED)\nmy_find_package(b REQUIRED)\n"
                  "find_package(${c} REQUIRED)\n#[[ x\nfind_package(d REQUIRED)\n]]\n"
                  "find_package(\"e\" REQUIRED)\nfind_package()\nfind_package( REQUIRED"),
            std::vector<std::string>());
}

TEST(CmakePackages, GoesThroughListsOfTheFile) {
  EXPECT_EQ(names("set(DEPENDENCIES ament_cmake rclcpp)\nlist(APPEND DEPENDENCIES Eigen3)\n"
                  "foreach(DEP IN LISTS DEPENDENCIES)\n  find_package(${DEP} REQUIRED)\n"
                  "endforeach()"),
            (std::vector<std::string>{"ament_cmake", "rclcpp", "Eigen3"}));
  EXPECT_EQ(names("set(more tf2)\nforeach(one std_msgs ${more} ${unknown})\n"
                  "find_package(${one} REQUIRED)\nendforeach()\n"
                  "foreach(one IN ITEMS urdf)\nfind_package(${one} REQUIRED)\nendforeach()"),
            (std::vector<std::string>{"std_msgs", "tf2", "urdf"}));
  // Each line doubles the list.
  std::string grows = "set(a x)\n";
  for (int i = 0; i < 64; ++i) grows += "set(a ${a} ${a})\n";
  EXPECT_EQ(names(grows + "find_package(${a} REQUIRED)"), std::vector<std::string>{"x"});
}

TEST(CmakePackages, KnowsThePlace) {
  const auto found = cmake_packages("project(x)\n  find_package(demo REQUIRED)  # why\n", "a/b");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].span.file, "a/b");
  EXPECT_EQ(found[0].span.line, 2U);
  EXPECT_EQ(found[0].span.column, 16U);
  EXPECT_EQ(found[0].span.length, 4U);
  EXPECT_EQ(found[0].span.line_text, "  find_package(demo REQUIRED)  # why");
}

TEST(CMakeProject, NameVersionAndPlace) {
  const auto project = cmake_project(
      "cmake_minimum_required(VERSION 3.8)\n# project(other)\n  PROJECT( \"my-math\"  VERSION 1.2 "
      "CXX)",
      "src/a/CMakeLists.txt");
  ASSERT_TRUE(project);
  EXPECT_EQ(project->name.value, "my-math");
  EXPECT_EQ(project->version, "1.2");
  EXPECT_EQ(project->name.span.line, 3U);
  EXPECT_EQ(project->name.span.column, 13U);
  EXPECT_EQ(cmake_project("set(NAME robot)\nproject(${NAME})", "f")->name.value, "robot");
  EXPECT_FALSE(cmake_project("project(${NAME})", "f"));
  EXPECT_FALSE(cmake_project("project()", "f"));
  for (const char* name : {"..", ".", ".hid", "-x"})
    EXPECT_FALSE(cmake_project("project(" + std::string(name) + ")", "f")) << name;
  EXPECT_FALSE(cmake_project("add_library(a a.c)", "f"));
}

// Guarantee, hostile input: a CMakeLists.txt whose lists double with each line, or that names tens
// of thousands of packages, is read in seconds and little memory
TEST(CmakePackages, ListsOfListsEnd) {
  const auto began = std::chrono::steady_clock::now();
  std::string doubling = "set(a x)\n";
  for (int i = 0; i < 60; ++i) doubling += "foreach(a IN LISTS a a)\n";
  EXPECT_EQ(names(doubling + "find_package(rclcpp REQUIRED)"), std::vector<std::string>{"rclcpp"});
  std::string appending = "set(a x)\n";
  for (int i = 0; i < 50'000; ++i) appending += "list(APPEND a ${a})\n";
  EXPECT_EQ(names(appending + "find_package(rclcpp REQUIRED)"), std::vector<std::string>{"rclcpp"});
  std::string copying = "set(a x)\n";
  for (int i = 0; i < 12; ++i) copying += "list(APPEND a ${a})\n";
  for (int i = 0; i < 50'000; ++i) copying += "set(v" + std::to_string(i) + " ${a})\n";
  EXPECT_EQ(names(copying + "find_package(rclcpp REQUIRED)"), std::vector<std::string>{"rclcpp"});
  std::string many;
  for (int i = 0; i < 50'000; ++i) many += "find_package(p" + std::to_string(i) + " REQUIRED)\n";
  EXPECT_EQ(names(many).size(), 50'000U);
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
}

}  // namespace
}  // namespace ros2wasm
