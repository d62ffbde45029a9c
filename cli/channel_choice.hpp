// The channels that a command names, opened: for commands without a workspace.
#pragma once

#include <span>
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

/// Where channels and lists lie for a command without a workspace.
[[nodiscard]] Outcome<ChannelRoots> chosen_roots(const ChannelChoice& choice,
                                                 const Context& context);

/// The channels, and those that `specs` name, which lose credentials. Errors of
/// channel_addresses(), add_named_channel() and open_channels().
[[nodiscard]] Outcome<OpenChannels> open_chosen_channels(const ChannelChoice& choice,
                                                         std::span<std::string> specs,
                                                         const Context& context);

}  // namespace ros2wasm
