// parameter_bridge: carries what its arguments say, and what its parameter `config_file` says.
#include "bridge.hpp"

int main(int argc, char** argv) {
  return ros_gz_bridge::run_bridge(argc, argv, true);
}
