// The program gz_sim.
#include "ros/server.hpp"

int main(int argc, char** argv) {
  return ros2wasm_sim::run_gz_sim(argc, argv);
}
