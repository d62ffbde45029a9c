// See workspace_channels.hpp.
#include "bundler/workspace/workspace_channels.hpp"

#include <utility>

#include "bundler/store/store.hpp"
#include "workspace_schema/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

/// What the manifest says of channels' addresses. The environment's alias is the manifest's
/// default.
Diagnostics use_manifest(const Manifest& manifest, ChannelNetwork& network) {
  Diagnostics errors;
  if (manifest.channel_alias) network.alias = manifest.channel_alias->value;
  const auto address_of = [&](const Spanned<std::string>& text) {
    auto address = channel_address(text.value, network);
    if (!address) append(errors, address.errors(), text.span);
    return address ? std::move(*address) : std::string();
  };
  for (const MirrorEntry& mirror : manifest.mirrors) {
    ChannelMirrors mirrors{.base = address_of(mirror.channel), .urls = {}};
    for (const auto& url : mirror.urls) mirrors.urls.push_back(address_of(url));
    network.mirrors.push_back(std::move(mirrors));
  }
  return errors;
}

}  // namespace

Outcome<WorkspaceChannels> workspace_channels(Manifest& manifest,
                                              const std::filesystem::path& folder,
                                              const std::filesystem::path& executable,
                                              const std::map<std::string, std::string>& variables) {
  WorkspaceChannels result{.roots = {.working_directory = folder,
                                     .embedded = {},
                                     .cache = default_cache_directory(variables),
                                     .network = network_of(variables)},
                           .addresses = {}};
  if (auto embedded = embedded_channel(executable)) result.roots.embedded = std::move(*embedded);
  Diagnostics errors = use_manifest(manifest, result.roots.network);
  std::vector<ChannelSource> channels;
  for (const auto& channel : manifest.channels) channels.push_back({channel.value, channel.span});
  if (channels.empty()) channels.push_back({kEmbeddedChannel, std::nullopt});
  auto addresses = channel_addresses(channels, result.roots);
  if (!addresses) {
    append(errors, addresses.errors());
    return errors;
  }
  result.addresses = std::move(*addresses);
  for (auto& [spec, span] : manifest.dependencies) {
    if (auto added = add_named_channel(spec, span, result.addresses, result.roots); !added)
      append(errors, added.errors());
  }
  if (!errors.empty()) return errors;
  return result;
}

}  // namespace ros2wasm
