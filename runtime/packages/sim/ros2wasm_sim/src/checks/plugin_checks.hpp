// Plugins that were written for another simulator, and parameters that a plugin does not read.
// Pure.
#pragma once

#include <string>
#include <vector>

#include "plugins/parameters.hpp"

namespace ros2wasm_sim {

/// The name that takes the place of a plugin that the simulator does not have: of ROS 1, or of the
/// other Gazebo. `name` is that of a library without `lib` and `.so`, or of a class without its
/// namespaces. Empty: nothing is known.
std::string successor_of(const std::string& name, bool is_classic);

/// Elements of a plugin that no version of it reads, and which one it does. None for a value that
/// the plugin has anyway.
std::vector<std::string> unread_elements(const std::string& name, const Parameters& given);

}  // namespace ros2wasm_sim
