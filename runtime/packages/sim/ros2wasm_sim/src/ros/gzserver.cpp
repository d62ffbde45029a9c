// gzserver: the server of Gazebo Classic, by its own options.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "ros/classic_server.hpp"
#include "ros/server.hpp"

namespace ros2wasm_sim {
namespace {

struct Arguments {
  std::string world;
  ClassicOptions options;
  std::uint64_t seed = 1;
};

/// Options whose value changes nothing here.
constexpr std::array kIgnored{"-e",
                              "--physics",
                              "-p",
                              "--play",
                              "--record_encoding",
                              "--record_path",
                              "--record_period",
                              "--record_filter",
                              "--iters",
                              "-o",
                              "--profile",
                              "-g",
                              "--gui-plugin"};

Arguments read(const std::vector<std::string>& words) {
  Arguments result;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto value = [&] { return i + 1 < words.size() ? words[++i] : std::string(); };
    if (word == "-s" || word == "--server-plugin") {
      const std::string plugin = value();
      result.options.init |= plugin.find("gazebo_ros_init") != std::string::npos;
      result.options.factory |= plugin.find("gazebo_ros_factory") != std::string::npos;
      result.options.forces |= plugin.find("gazebo_ros_force_system") != std::string::npos;
    } else if (word == "--seed") {
      result.seed = std::strtoull(value().c_str(), nullptr, 10);
    } else if (word == "--initial_sim_time") {
      result.options.initial_time = std::strtod(value().c_str(), nullptr);
    } else if (std::find(kIgnored.begin(), kIgnored.end(), word) != kIgnored.end()) {
      value();
    } else if (word == "-u" || word == "--pause") {
      result.options.paused = true;
    } else if (!word.empty() && word.front() != '-' && result.world.empty()) {
      result.world = word;
    }
  }
  return result;
}

}  // namespace

int run_gzserver(int argc, char** argv, std::vector<PluginRow> plugins) {
  const Arguments arguments = read(rclcpp::init_and_remove_ros_arguments(argc, argv));
  ServerSettings settings;
  settings.node = "gazebo";
  settings.seed = arguments.seed;
  settings.plugins = std::move(plugins);
  settings.load = [&](const rclcpp::Logger& logger) {
    auto world = load_world(logger, arguments.world.empty() ? "empty.sdf" : arguments.world);
    if (!world) return world;
    // Gazebo Classic follows its update rate, not the factor that is written.
    world->physics.real_time_factor =
        world->physics.real_time_update_rate.value_or(1000) * world->physics.max_step_size;
    return world;
  };
  settings.offer = [&](Host& host, Simulation& simulation) {
    return std::make_shared<ClassicServer>(host, simulation, arguments.options);
  };
  return run_server(settings);
}

}  // namespace ros2wasm_sim
