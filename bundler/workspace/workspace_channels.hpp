// The channels of a workspace: what its manifest and the environment say of addresses, in one
// place for every command. Asks the disk which folders there are, brings nothing.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct WorkspaceChannels {
  ChannelRoots roots;  ///< `embedded` is empty where the program has no channel
  std::vector<ChannelSource> addresses;
};

/// `folder`: of the manifest. Dependencies that name a channel are rewritten as add_named_channel()
/// says. All mistakes at once: R2W0237, R2W0240, R2W0303.
[[nodiscard]] Outcome<WorkspaceChannels> workspace_channels(
    Manifest& manifest, const std::filesystem::path& folder,
    const std::filesystem::path& executable, const std::map<std::string, std::string>& variables);

}  // namespace ros2wasm
