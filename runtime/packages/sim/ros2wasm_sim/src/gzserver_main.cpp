// gzserver: the server of Gazebo Classic, by its own options.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "mesh/read_mesh.hpp"
#include "ros/classic_server.hpp"

namespace {

using namespace ros2wasm_sim;

struct Arguments {
  std::string world;
  ClassicOptions options;
  std::uint64_t seed = 1;
};

/// Options with a value that changes nothing here.
constexpr std::array kWithValue{"-s",
                                "--server-plugin",
                                "-e",
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
                                "--initial_sim_time",
                                "-g",
                                "--gui-plugin"};

Arguments read(const std::vector<std::string>& words) {
  Arguments result;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string value = i + 1 < words.size() ? words[i + 1] : "";
    if (word == "-s" || word == "--server-plugin") {
      result.options.init |= value.find("gazebo_ros_init") != std::string::npos;
      result.options.factory |= value.find("gazebo_ros_factory") != std::string::npos;
      result.options.state |= value.find("gazebo_ros_state") != std::string::npos;
    }
    if (word == "--seed")
      result.seed = std::strtoull(value.c_str(), nullptr, 10), ++i;
    else if (std::find(kWithValue.begin(), kWithValue.end(), word) != kWithValue.end())
      ++i;
    else if (word == "-u" || word == "--pause")
      result.options.paused = true;
    else if (!word.empty() && word.front() != '-' && result.world.empty())
      result.world = word;
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = read(rclcpp::init_and_remove_ros_arguments(argc, argv));
  auto node = std::make_shared<rclcpp::Node>("gazebo");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  Host host(node, executor, arguments.seed);
  auto world =
      load_world(node->get_logger(), arguments.world.empty() ? "empty.sdf" : arguments.world);
  if (!world) return 255;
  // Gazebo Classic follows its update rate, not the factor that is written.
  world->physics.real_time_factor =
      world->physics.real_time_update_rate.value_or(1000) * world->physics.max_step_size;
  ClassicOptions options = arguments.options;
  for (const Plugin& plugin : world->plugins)
    options.state |= plugin.filename.find("gazebo_ros_state") != std::string::npos;
  try {
    PluginTable table(host, Flavour::kClassic);
    Simulation simulation(std::move(*world), make_physics(site_meshes(node->get_logger())), table);
    ClassicServer server(host, simulation, options);
    executor.spin();
  } catch (const PhysicsError& error) {
    RCLCPP_ERROR(node->get_logger(), "the world cannot be simulated: %s", error.what());
    return 255;
  }
  rclcpp::shutdown();
  return 0;
}
