// gz_sim: the server of Gazebo Sim, by the options of `gz sim`.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "mesh/read_mesh.hpp"
#include "ros/sim_server.hpp"

namespace {

using namespace ros2wasm_sim;

struct Arguments {
  std::string world, text;
  SimOptions options;
  double rate = 0;  ///< steps a second; 0: as the world says
  std::uint64_t seed = 1;
};

/// Options with a value that changes nothing here.
constexpr std::array kWithValue{
    "--force-version",        "--physics-engine", "--render-engine",      "--render-engine-gui",
    "--render-engine-server", "--record-path",    "--record-topic",       "--playback",
    "--gui-config",           "--network-role",   "--network-secondaries"};

/// `-r`, or as one of several flags, `-rs`.
bool lets_run(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         word.find_first_not_of("gsr", 1) == std::string::npos &&
         word.find('r', 1) != std::string::npos;
}

bool is_digit(const std::string& word) {
  return word.size() == 1 && word[0] >= '0' && word[0] <= '4';
}

Arguments read(const std::vector<std::string>& words) {
  Arguments result;
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::string value = i + 1 < words.size() ? words[i + 1] : "";
    if (lets_run(word))
      result.options.runs = true;
    else if (word == "--iterations")
      result.options.steps = std::strtoull(value.c_str(), nullptr, 10), ++i;
    else if (word == "-z")
      result.rate = std::strtod(value.c_str(), nullptr), ++i;
    else if (word == "--seed")
      result.seed = std::strtoull(value.c_str(), nullptr, 10), ++i;
    else if (word == "--initial-sim-time")
      result.options.initial_time = std::strtod(value.c_str(), nullptr), ++i;
    else if (word == "--sdf-string")
      result.text = value, ++i;
    else if (word == "-v" || word == "--verbose")
      i += is_digit(value) ? 1 : 0;
    else if (std::find(kWithValue.begin(), kWithValue.end(), word) != kWithValue.end())
      ++i;
    else if (!word.empty() && word.front() != '-' && result.world.empty())
      result.world = word;
  }
  return result;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments arguments = read(rclcpp::init_and_remove_ros_arguments(argc, argv));
  auto node = std::make_shared<rclcpp::Node>("_gz_sim");
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  Host host(node, executor, arguments.seed);
  auto world =
      arguments.text.empty()
          ? load_world(node->get_logger(), arguments.world.empty() ? "empty.sdf" : arguments.world)
          : load_world_text(node->get_logger(), arguments.text, "");
  if (!world) return 255;
  if (arguments.rate > 0)
    world->physics.real_time_factor = arguments.rate * world->physics.max_step_size;
  try {
    PluginTable table(host, Flavour::kSim);
    Simulation simulation(std::move(*world), make_physics(site_meshes(node->get_logger())), table);
    SimServer server(host, simulation, arguments.options);
    executor.spin();
  } catch (const PhysicsError& error) {
    RCLCPP_ERROR(node->get_logger(), "the world cannot be simulated: %s", error.what());
    return 255;
  }
  rclcpp::shutdown();
  return 0;
}
