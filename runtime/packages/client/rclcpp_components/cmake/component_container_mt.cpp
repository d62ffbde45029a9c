// The containers with threads, `component_container_mt` and `component_container_isolated`: one
// program, which is what it is called.
#include <string>

#include "rclcpp_components/component_program.hpp"

int main(int argc, char** argv) {
  const std::string path = argc > 0 ? argv[0] : "";
  return rclcpp_components::run_container_mt(argc, argv, path.substr(path.rfind('/') + 1).c_str());
}
