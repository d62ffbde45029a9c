// bridge_node: carries what its parameter `config_file` says.
#include "bridge.hpp"

int main(int argc, char** argv) {
  return ros_gz_bridge::run_bridge(argc, argv, false);
}
