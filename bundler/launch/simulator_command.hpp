// Command lines of launch files that start Gazebo, and the programs of the site's own simulator
// that do their work. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/workspace/launch_packages.hpp"

namespace ros2wasm {

/// Whether it is the simulator, or one of Gazebo's packages whose programs the simulator's channel
/// has.
[[nodiscard]] bool is_simulator_package(std::string_view package);

/// The program that replaces a command line which starts Gazebo.
struct SimulatorCommand {
  /// A program of kSimulatorPackage, and of kControlledSimulatorPackage. Empty: the command only
  /// opens a window; the page replaces it.
  std::string program;
  std::vector<std::string> arguments;
};

/// For `gz sim ...`, `ign gazebo ...`, `gazebo ...`, `gzserver ...` and `gzclient ...`, each also
/// by path, and with `ruby` before it. Nothing for other commands, also those of `gz`.
[[nodiscard]] std::optional<SimulatorCommand> simulator_command(
    const std::vector<std::string>& words);

/// A line for a shell where `$(which gz)` and `$(which ign)` are the program that they find.
[[nodiscard]] std::string without_which(std::string line);

/// Whether a program of this name starts Gazebo: `gz`, `gzserver` and similar.
[[nodiscard]] bool is_program_of_gazebo(std::string_view name);

}  // namespace ros2wasm
