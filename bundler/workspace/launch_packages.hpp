// Which packages a launch file or a description names, as far as its text tells. Pure; nothing is
// evaluated here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Does `ros2 launch` offer a file of this name, or do launch files include such ones?
[[nodiscard]] bool is_launch_file_name(std::string_view name);

/// The simulator, with the programs `gzserver` and `gz_sim`. A launch file that starts Gazebo as a
/// process needs it, and no package.xml names it.
inline constexpr std::string_view kSimulatorPackage = "ros2wasm_sim";
/// The same programs with ros2_control in them. They take the place of the others in a workspace
/// that has this package, which gazebo_ros2_control and gz_ros2_control need.
inline constexpr std::string_view kControlledSimulatorPackage = "ros2wasm_sim_control";

/// Whether a program of this package is the simulator.
[[nodiscard]] inline bool is_simulator(std::string_view package) {
  return package == kSimulatorPackage || package == kControlledSimulatorPackage;
}

/// Packages of nodes (`package='a'`, `pkg="a"`, `pkg: a`) and those that are looked up
/// (`FindPackageShare('a')`, `$(find-pkg-share a)`), and kSimulatorPackage for commands that start
/// Gazebo (`cmd=['gz', 'sim']`), in the order of the file, each once. What a variable names is not
/// told. `file` is only for messages.
[[nodiscard]] std::vector<Spanned<std::string>> launch_packages(std::string_view text,
                                                                const std::string& file);

/// Whether a description of a robot or a world has this name: URDF, xacro or SDF.
[[nodiscard]] bool is_description_name(std::string_view name);

/// Packages whose plugins a description loads into the simulator by their library, such as
/// gz_ros2_control; in the order of the file, each once.
[[nodiscard]] std::vector<Spanned<std::string>> description_packages(std::string_view text,
                                                                     const std::string& file);

}  // namespace ros2wasm
