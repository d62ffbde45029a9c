// Command lines of launch files that start Gazebo.
#include "bundler/launch/simulator_command.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

using Words = std::vector<std::string>;

/// The program and its arguments; "(page)" for what the page replaces, "(none)" for other commands.
Words started(const Words& words) {
  const auto command = simulator_command(words);
  if (!command) return {"(none)"};
  if (command->program.empty()) return {"(page)"};
  Words result{command->program};
  result.insert(result.end(), command->arguments.begin(), command->arguments.end());
  return result;
}

TEST(SimulatorCommand, StartsTheServer) {
  EXPECT_EQ(started({"gz", "sim", "-r", "w.sdf"}), (Words{"gz_sim", "-r", "w.sdf"}));
  EXPECT_EQ(started({"/usr/bin/gz", "sim"}), (Words{"gz_sim"}));
  EXPECT_EQ(started({"ruby", "/usr/bin/gz", "sim", "-v", "4"}), (Words{"gz_sim", "-v", "4"}));
  EXPECT_EQ(started({"ign", "gazebo", "-r"}), (Words{"gz_sim", "-r"}));
  EXPECT_EQ(started({"ign", "sim"}), (Words{"gz_sim"}));
  EXPECT_EQ(started({"gzserver", "-s", "libgazebo_ros_init.so", "w.world"}),
            (Words{"gzserver", "-s", "libgazebo_ros_init.so", "w.world"}));
  EXPECT_EQ(started({"gazebo", "--verbose"}), (Words{"gzserver", "--verbose"}));
}

TEST(SimulatorCommand, LeavesTheWindowToThePage) {
  EXPECT_EQ(started({"gzclient"}), (Words{"(page)"}));
  EXPECT_EQ(started({"gz", "sim", "-g", "-v2"}), (Words{"(page)"}));
  EXPECT_EQ(started({"gz", "sim", "-s", "-g"}), (Words{"gz_sim", "-s", "-g"}));
  EXPECT_EQ(started({"gz", "sim", "-rs", "-g"}), (Words{"gz_sim", "-rs", "-g"}));
}

TEST(SimulatorCommand, KnowsNoOthers) {
  for (const Words& words : {Words{}, Words{"ruby"}, Words{"gz"}, Words{"gz", "topic", "-l"},
                             Words{"gz", "gazebo"}, Words{"xgzserver"}, Words{"ros2", "gz", "sim"}})
    EXPECT_EQ(started(words), (Words{"(none)"}));
}

TEST(SimulatorCommand, FindsWhatAShellWouldFind) {
  EXPECT_EQ(without_which("ruby $(which gz) sim -r"), "ruby gz sim -r");
  EXPECT_EQ(without_which("`which ign` gazebo"), "ign gazebo");
  EXPECT_EQ(without_which("$(which ls)"), "$(which ls)");
}

TEST(SimulatorCommand, KnowsItsPackages) {
  EXPECT_TRUE(is_simulator_package("gazebo_ros"));
  EXPECT_TRUE(is_simulator_package("ros_gz_bridge"));
  EXPECT_TRUE(is_simulator_package("gazebo_ros2_control"));
  EXPECT_FALSE(is_simulator_package("gazebo_ros_control"));
}

}  // namespace
}  // namespace ros2wasm
