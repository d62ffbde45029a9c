// The program gz_sim with the plugins of ros2_control.
#include "control_plugin.hpp"
#include "ros/server.hpp"

int main(int argc, char** argv) {
  return ros2wasm_sim::run_gz_sim(argc, argv, ros2wasm_sim::control_plugins());
}
