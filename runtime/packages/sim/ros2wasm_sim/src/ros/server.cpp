// See server.hpp.
#include "ros/server.hpp"

#include "mesh/read_mesh.hpp"
#include "ros/resources.hpp"
#include "ros/world_watch.hpp"

namespace ros2wasm_sim {

int run_server(const ServerSettings& settings) {
  constexpr int kFailed = 255;
  auto node = std::make_shared<rclcpp::Node>(settings.node);
  const auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  executor->add_node(node);
  Host host(node, executor, settings.seed);
  auto world = settings.load(node->get_logger());
  if (!world) return kFailed;
  try {
    const MeshReader meshes = site_meshes(node->get_logger());
    PluginTable table(host, settings.flavour, {meshes, site_resources().read}, settings.plugins);
    Simulation simulation(std::move(*world), make_physics(meshes), table);
    const std::shared_ptr<void> offered = settings.offer(host, simulation);
    const WorldWatch watch(node, settings.flavour == Flavour::kSim);
    executor->spin();
  } catch (const PhysicsError& error) {
    RCLCPP_ERROR(node->get_logger(), "the world cannot be simulated: %s", error.what());
    return kFailed;
  }
  rclcpp::shutdown();
  return 0;
}

}  // namespace ros2wasm_sim
