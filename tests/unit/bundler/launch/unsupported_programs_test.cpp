// The panels that a site opens at first for the programs of its launch file.
#include "bundler/launch/unsupported_programs.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

namespace ros2wasm {
namespace {

std::vector<StandInPanel> panels_for(std::initializer_list<const char*> packages, bool is_known) {
  LaunchDescription description;
  for (const char* package : packages) {
    LaunchProcess process;
    process.node.package.value = package;
    description.processes.push_back(process);
  }
  return stand_in_panels(description, [is_known](const std::string&) { return is_known; });
}

TEST(UnsupportedPrograms, TeleopIsOpenForGamepadsWhetherJoyIsInTheSiteOrNot) {
  const std::vector<StandInPanel> teleop = {{.panel = "teleop", .file = ""}};
  EXPECT_EQ(panels_for({"joy", "teleop_twist_joy", "joy"}, true), teleop);
  EXPECT_EQ(panels_for({"joy", "joy_linux"}, false), teleop);
  EXPECT_TRUE(panels_for({"teleop_twist_joy"}, true).empty());
  LaunchDescription composed;
  composed.processes.emplace_back().components.emplace_back().node.package.value = "joy";
  EXPECT_EQ(stand_in_panels(composed, [](const std::string&) { return true; }), teleop);
}

}  // namespace
}  // namespace ros2wasm
