// gz_sim: the server of Gazebo Sim, by the options of `gz sim`.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "ros/server.hpp"
#include "ros/sim_server.hpp"
#include "ros2wasm_sim/gz_names.hpp"

namespace ros2wasm_sim {
namespace {

struct Arguments {
  std::string world, text;
  SimOptions options;
  double rate = 0;  ///< steps a second; 0: as the world says
  std::uint64_t seed = 1;
};

/// Options whose value changes nothing here.
constexpr std::array kIgnored{
    "--force-version",        "--physics-engine", "--render-engine",      "--render-engine-gui",
    "--render-engine-server", "--record-path",    "--record-topic",       "--playback",
    "--gui-config",           "--network-role",   "--network-secondaries"};

/// `-r`, or as one of several flags, `-rs`.
bool lets_run(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         word.find_first_not_of("gsr", 1) == std::string::npos &&
         word.find('r', 1) != std::string::npos;
}

/// A level of messages, which may follow `-v`.
bool is_level(const std::string& word) {
  return word.size() == 1 && word[0] >= '0' && word[0] <= '4';
}

Arguments read(const std::vector<std::string>& words) {
  Arguments result;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&] { return i + 1 < words.size() ? words[++i] : std::string(); };
    if (lets_run(word)) {
      result.options.runs = true;
    } else if (word == "--iterations") {
      result.options.steps = std::strtoull(value().c_str(), nullptr, 10);
    } else if (word == "-z") {
      result.rate = std::strtod(value().c_str(), nullptr);
    } else if (word == "--seed") {
      result.seed = std::strtoull(value().c_str(), nullptr, 10);
    } else if (word == "--initial-sim-time") {
      result.options.initial_time = std::strtod(value().c_str(), nullptr);
    } else if (word == "--simulation-interfaces") {  // as the node GzServer has them
      result.options.any_make = true;
    } else if (word == "--sdf-string") {
      result.text = value();
    } else if (word == "-v" || word == "--verbose") {
      if (i + 1 < words.size() && is_level(words[i + 1])) ++i;
    } else if (std::find(kIgnored.begin(), kIgnored.end(), word) != kIgnored.end()) {
      value();
    } else if (!word.empty() && word.front() != '-' && result.world.empty()) {
      result.world = word;
    }
  }
  return result;
}

}  // namespace

int run_gz_sim(int argc, char** argv, std::vector<PluginRow> plugins) {
  const Arguments arguments = read(rclcpp::init_and_remove_ros_arguments(argc, argv));
  ServerSettings settings;
  settings.node = kServerNode;
  settings.flavour = Flavour::kSim;
  settings.seed = arguments.seed;
  settings.plugins = std::move(plugins);
  settings.load = [&](const rclcpp::Logger& logger) {
    auto world = arguments.text.empty()
                     ? load_world(logger, arguments.world.empty() ? "empty.sdf" : arguments.world)
                     : load_world_text(logger, arguments.text, "");
    if (world && arguments.rate > 0)
      world->physics.real_time_factor = arguments.rate * world->physics.max_step_size;
    return world;
  };
  settings.offer = [&](Host& host, Simulation& simulation) {
    return std::make_shared<SimServer>(host, simulation, arguments.options);
  };
  return run_server(settings);
}

}  // namespace ros2wasm_sim
