#include "bundler/workspace/bringup_file.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

TEST(BringupFile, TheOnlyOneIsTaken) {
  const BringupChoice choice = bringup_file({"src/demo/launch/demo.launch.py"});
  EXPECT_EQ(choice.file, "src/demo/launch/demo.launch.py");
  EXPECT_TRUE(choice.candidates.empty());
}

TEST(BringupFile, OneThatSaysSoIsTakenAmongOthers) {
  const BringupChoice choice =
      bringup_file({"src/a/launch/view.launch.py", "src/b/launch/bringup.launch.xml"});
  EXPECT_EQ(choice.file, "src/b/launch/bringup.launch.xml");
  EXPECT_EQ(choice.candidates, std::vector<std::string>{"src/a/launch/view.launch.py"});
  // By its package, when no name of a file tells.
  EXPECT_EQ(
      bringup_file({"src/arm/launch/a.launch.py", "src/arm_bringup/launch/robot.launch.py"}).file,
      "src/arm_bringup/launch/robot.launch.py");
}

TEST(BringupFile, AmongEqualsNoneIsTaken) {
  const std::vector<std::string> two = {"a/launch/bringup.launch.py", "b/launch/bringup.launch.py"};
  EXPECT_EQ(bringup_file(two).file, "");
  EXPECT_EQ(bringup_file(two).candidates, two);
  EXPECT_EQ(bringup_file({"a/launch/x.launch.py", "a/launch/y.launch.py"}).file, "");
  EXPECT_EQ(bringup_file({}).file, "");
}

}  // namespace
}  // namespace ros2wasm
