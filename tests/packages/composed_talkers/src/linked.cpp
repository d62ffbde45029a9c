// Makes every component that was linked into this program, and says which they are.

// Compatibility, differs: `add_library(SHARED)` -> linked statically: a site has one wasm file for
// each program

#include <cstdio>

#include "class_loader/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  class_loader::ClassLoader loader("");
  for (const std::string& name : loader.getAvailableClasses<rclcpp_components::NodeFactory>()) {
    auto wrapper =
        loader.createInstance<rclcpp_components::NodeFactory>(name)->create_node_instance(
            rclcpp::NodeOptions());
    std::printf("%s\n", wrapper.get_node_base_interface()->get_fully_qualified_name());
  }
  rclcpp::shutdown();
  return 0;
}
