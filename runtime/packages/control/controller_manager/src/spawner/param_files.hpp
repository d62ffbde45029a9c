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

/// The same in the spawner's own ROS arguments: a site gives the parameters of a launch file one by
/// one, `-p /wheels:type:='a/B'`, and not in a file, which another program could not open.
struct ControllerArgumentFacts {
  std::string type;
  std::vector<std::string> fallbacks;
  std::vector<std::string> ros_args;  ///< for the node of the controller; empty: there are none
};

ControllerArgumentFacts read_param_arguments(const std::string& controller,
                                             const std::string& name_space,
                                             const std::vector<std::string>& arguments);

}  // namespace controller_manager
