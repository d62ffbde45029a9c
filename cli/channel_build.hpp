// `ros2wasm channel build`: the words and options of that action.
#pragma once

#include <string>
#include <vector>

#include "cli/context.hpp"

namespace ros2wasm {

struct ChannelBuildOptions {
  std::vector<std::string> words;  ///< a workspace, or .repos files and names of packages
  std::string output;
  std::string distribution;
  std::string report;
  bool locked = false;
  bool offline = false;
  int jobs = 0;
};

[[nodiscard]] int run_channel_build(const ChannelBuildOptions& options, Context& context);

}  // namespace ros2wasm
