// The YAML of a bridge's `config_file`: a list of topics and services.
#pragma once

#include <string>
#include <vector>

#include "bridge_argument.hpp"

namespace ros_gz_bridge {

struct BridgeConfig {
  std::vector<BridgeArgument> entries;
  std::vector<std::string> faults;  ///< in the words of ros_gz_bridge; an entry with one is skipped
};

BridgeConfig read_bridge_config(const std::string& yaml);
BridgeConfig read_bridge_config_file(const std::string& path);

}  // namespace ros_gz_bridge
