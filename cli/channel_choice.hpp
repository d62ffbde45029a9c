// The channels that a command names, opened: for commands without a workspace.
#pragma once

#include <string>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "cli/context.hpp"

namespace ros2wasm {

struct ChannelChoice {
  std::vector<std::string> channels;  ///< none: the embedded one
  bool offline = false;
  std::string platform;  ///< beside noarch; empty: emscripten-wasm32
};

/// Errors of channel_addresses() and open_channels().
[[nodiscard]] Outcome<OpenChannels> open_chosen_channels(const ChannelChoice& choice,
                                                         const Context& context);

}  // namespace ros2wasm
