// A program that components are loaded into.
#include <memory>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/component_manager.hpp"
#include "rclcpp_components/component_program.hpp"

namespace rclcpp_components {

int run_container(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto executor = std::make_shared<rclcpp::executors::SingleThreadedExecutor>();
  auto manager = std::make_shared<ComponentManager>(executor);
  executor->add_node(manager);
  executor->spin();
  return 0;
}

}  // namespace rclcpp_components
