// loaded LIBRARY...: makes the components of each library and spins them; says which libraries
// there are not.

// Compatibility, works: libraries of components linked into one program, and loaded by name with
// `class_loader`

// Compatibility, differs: loading a library at run time (`class_loader`) -> finds the libraries of
// classes that the program was linked with: those that it names, else, for a program that links
// `class_loader`, all components of its package; another one throws `LibraryLoadException`

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

int main(int argc, char** argv) {
  const std::vector<std::string> words = rclcpp::init_and_remove_ros_arguments(argc, argv);
  rclcpp::executors::SingleThreadedExecutor executor;
  std::vector<std::unique_ptr<class_loader::ClassLoader>> loaders;
  std::vector<rclcpp_components::NodeInstanceWrapper> nodes;
  for (std::size_t i = 1; i < words.size(); ++i) {
    try {
      loaders.push_back(std::make_unique<class_loader::ClassLoader>(words[i]));
    } catch (const class_loader::LibraryLoadException& error) {
      std::printf("%s\n", error.what());
      continue;
    }
    for (const std::string& name :
         loaders.back()->getAvailableClasses<rclcpp_components::NodeFactory>()) {
      std::printf("%s has %s\n", words[i].c_str(), name.c_str());
      nodes.push_back(loaders.back()
                          ->createInstance<rclcpp_components::NodeFactory>(name)
                          ->create_node_instance(rclcpp::NodeOptions()));
      executor.add_node(nodes.back().get_node_base_interface());
    }
  }
  std::fflush(stdout);
  executor.spin();
  rclcpp::shutdown();
  return 0;
}
