// See workspace_channels.hpp.
#include "bundler/workspace/workspace_channels.hpp"

#include <utility>

#include "bundler/channel/transport.hpp"
#include "bundler/store/cache_place.hpp"
#include "workspace_schema/base/diagnostic_list.hpp"

namespace ros2wasm {
namespace {

/// Applies the manifest's settings for channels' addresses. The environment's alias counts when the
/// manifest has none.
Diagnostics use_manifest(const Manifest& manifest, ChannelRoots& roots) {
  Diagnostics errors;
  ChannelNetwork& network = roots.network;
  if (manifest.channel_alias) network.alias = manifest.channel_alias->value;
  for (const MirrorEntry& mirror : manifest.mirrors) {
    auto base = channel_address(mirror.channel.value, network);
    if (!base) {
      append(errors, base.errors(), mirror.channel.span);
      continue;
    }
    std::vector<ChannelSource> named;
    for (const auto& url : mirror.urls) named.push_back({.name = url.value, .span = url.span});
    const auto places = channel_addresses(named, roots);
    if (!places) {
      append(errors, places.errors());
      continue;
    }
    ChannelMirrors mirrors{.base = std::move(*base), .urls = {}};
    for (const ChannelSource& one : *places) {
      std::error_code error;
      const auto folder = local_channel_folder(one.name, roots.working_directory);
      mirrors.urls.push_back(
          folder ? std::filesystem::absolute(*folder, error).lexically_normal().string()
                 : one.name);
    }
    network.mirrors.push_back(std::move(mirrors));
  }
  return errors;
}

}  // namespace

Outcome<WorkspaceChannels> workspace_channels(Manifest& manifest,
                                              const std::filesystem::path& folder,
                                              const std::filesystem::path& executable,
                                              const std::map<std::string, std::string>& variables) {
  auto cache = cache_directory(variables);
  if (!cache) return std::move(cache).errors();
  WorkspaceChannels result{.roots = {.working_directory = folder,
                                     .embedded = {},
                                     .cache = std::move(*cache),
                                     .network = network_of(variables)},
                           .addresses = {}};
  if (auto embedded = embedded_channel(executable)) result.roots.embedded = std::move(*embedded);
  Diagnostics errors = use_manifest(manifest, result.roots);
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
