// See simulator_command.hpp.
#include "bundler/launch/simulator_command.hpp"

#include <algorithm>
#include <array>

#include "bundler/launch/ros2_command.hpp"

namespace ros2wasm {
namespace {

constexpr auto kPackages = std::to_array<std::string_view>(
    {"gazebo_dev", "gazebo_msgs", "gazebo_plugins", "gazebo_ros", "gazebo_ros2_control",
     "gazebo_ros_pkgs", "gz_ros2_control", "ign_ros2_control", "ros2wasm_sim",
     "ros2wasm_sim_control", "ros_gz", "ros_gz_bridge", "ros_gz_image", "ros_gz_interfaces",
     "ros_gz_sim", "ros_ign_bridge", "ros_ign_gazebo", "ros_ign_image"});

constexpr auto kPrograms =
    std::to_array<std::string_view>({"gazebo", "gz", "gzclient", "gzserver", "ign"});

/// Whether a word sets this flag of `gz sim`: `-g`, or as one of several, `-rg`.
bool sets_flag(const std::string& word, char flag) {
  constexpr std::string_view kFlags = "gsr";
  return word.size() > 1 && word[0] == '-' &&
         word.find_first_not_of(kFlags, 1) == std::string::npos &&
         word.find(flag, 1) != std::string::npos;
}

bool any_sets(const std::vector<std::string>& words, char flag) {
  return std::any_of(words.begin(), words.end(),
                     [&](const std::string& word) { return sets_flag(word, flag); });
}

/// The program for `gz sim`; `-s` wins over `-g`.
SimulatorCommand sim_command(std::vector<std::string> arguments) {
  if (any_sets(arguments, 'g') && !any_sets(arguments, 's')) return {};
  return {"gz_sim", std::move(arguments)};
}

}  // namespace

bool is_simulator_package(std::string_view package) {
  return std::find(kPackages.begin(), kPackages.end(), package) != kPackages.end();
}

bool is_program_of_gazebo(std::string_view name) {
  return std::find(kPrograms.begin(), kPrograms.end(), name) != kPrograms.end();
}

std::optional<SimulatorCommand> simulator_command(const std::vector<std::string>& words) {
  std::size_t at = 0;
  if (!words.empty() && names_program(words[0], "ruby")) ++at;
  if (at >= words.size()) return std::nullopt;
  const std::string& program = words[at];
  const auto rest = [&](std::size_t after) {
    return std::vector<std::string>(words.begin() + static_cast<std::ptrdiff_t>(at + after),
                                    words.end());
  };
  const bool is_ign = names_program(program, "ign");
  if (is_ign || names_program(program, "gz")) {
    const bool starts =
        at + 1 < words.size() && (words[at + 1] == "sim" || (is_ign && words[at + 1] == "gazebo"));
    if (!starts) return std::nullopt;
    return sim_command(rest(2));
  }
  if (names_program(program, "gzserver") || names_program(program, "gazebo"))
    return SimulatorCommand{"gzserver", rest(1)};
  if (names_program(program, "gzclient")) return SimulatorCommand{};
  return std::nullopt;
}

std::string without_which(std::string line) {
  for (const std::string_view program : {std::string_view("gz"), std::string_view("ign")}) {
    const std::string name(program);
    for (const std::string& call : {"$(which " + name + ")", "`which " + name + "`"}) {
      for (auto at = line.find(call); at != std::string::npos; at = line.find(call))
        line.replace(at, call.size(), name);
    }
  }
  return line;
}

}  // namespace ros2wasm
