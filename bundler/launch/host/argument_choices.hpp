// Which values of launch arguments are tried when a site is packed. Pure.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "bundler/launch/launch_description.hpp"

namespace ros2wasm {

struct ArgumentTrials {
  /// Launch arguments by name; those that stay as they are, are skipped. One other value first,
  /// then two at once, and so on, in the order of declaration.
  std::vector<std::map<std::string, std::string>> trials;
  bool is_complete = true;
  std::vector<std::string> names;  ///< of the arguments that have other values to try
};

/// The choices of each argument; for one that is true or false, the other. `most` trials.
[[nodiscard]] ArgumentTrials argument_trials(const std::vector<LaunchArgument>& arguments,
                                             std::size_t most);

}  // namespace ros2wasm
