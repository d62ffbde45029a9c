// See channel_choice.hpp.
#include "cli/channel_choice.hpp"

#include <filesystem>

#include "bundler/store/cache_place.hpp"

namespace ros2wasm {

Outcome<ChannelRoots> chosen_roots(const ChannelChoice& choice, const Context& context) {
  std::error_code error;
  auto cache = cache_directory(context.environment);
  if (!cache) return std::move(cache).errors();
  ChannelRoots roots{.working_directory = std::filesystem::current_path(error),
                     .embedded = {},
                     .cache = std::move(*cache),
                     .network = network_of(context.environment)};
  roots.network.offline = choice.offline;
  if (!choice.platform.empty()) roots.platform = choice.platform;
  if (auto embedded = embedded_channel(context.executable)) roots.embedded = std::move(*embedded);
  return roots;
}

Outcome<OpenChannels> open_chosen_channels(const ChannelChoice& choice,
                                           std::span<std::string> specs, const Context& context) {
  auto made = chosen_roots(choice, context);
  if (!made) return std::move(made).errors();
  ChannelRoots roots = *std::move(made);
  std::vector<ChannelSource> channels;
  for (const std::string& name : choice.channels) channels.push_back({.name = name, .span = {}});
  if (channels.empty()) channels.push_back({.name = "embedded", .span = {}});
  auto addresses = channel_addresses(channels, roots);
  if (!addresses) return std::move(addresses).errors();
  for (std::string& spec : specs) {
    if (auto added = add_named_channel(spec, std::nullopt, *addresses, roots); !added)
      return std::move(added).errors();
  }
  return open_channels(*addresses, roots, context.cancellation, context.progress);
}

}  // namespace ros2wasm
