// A controller as its parameters describe it, before it is made.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace hardware_interface {

struct ControllerInfo {
  std::string name;
  std::string type;
  std::vector<std::string> parameters_files;
  std::vector<std::string> claimed_interfaces;
  std::vector<std::string> fallback_controllers_names;
  std::vector<std::string> node_options_args;
};

}  // namespace hardware_interface
