// Facts about a controller in parameter files, before it is loaded. This file needs no ROS node.
#pragma once

#include <string>
#include <vector>

namespace controller_manager {

struct ControllerFileFacts {
  std::vector<std::string> files;  ///< those with parameters of the controller
  std::string type;                ///< of the first file that has it
  std::vector<std::string> fallbacks;
  bool lacks_namespace = false;  ///< a key is the bare name, and the namespace is not the root
};

/// `name_space` begins with a slash. Throws std::runtime_error for a file that is not a parameter
/// file.
ControllerFileFacts read_param_files(const std::string& controller, const std::string& name_space,
                                     const std::vector<std::string>& files);

}  // namespace controller_manager
