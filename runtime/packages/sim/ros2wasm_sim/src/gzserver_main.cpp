// The program gzserver.
#include "ros/server.hpp"

int main(int argc, char** argv) {
  return ros2wasm_sim::run_gzserver(argc, argv);
}
