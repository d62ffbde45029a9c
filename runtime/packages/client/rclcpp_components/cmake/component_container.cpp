// The container of a package's components.
#include "rclcpp_components/component_program.hpp"

int main(int argc, char** argv) {
  return rclcpp_components::run_container(argc, argv);
}
