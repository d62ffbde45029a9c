// Packages that neither the workspace, its sources nor a channel has, from the release repositories
// of a ROS distribution (`distribution:` of `sources:`). Reads the lock, the disk and, unless it is
// offline, the network.
#pragma once

#include <string>
#include <vector>

#include "bundler/workspace_sources.hpp"

namespace ros2wasm {

/// Adds to `packages` what a build, an import or something that is launched needs, and in turn what
/// that needs, as far as the lock or a distribution file of the manifest knows it. `known_names`:
/// of the channels, sorted. `sources` gets what was fetched. A lock that must fit is not added to.
/// Errors are those of add_source_packages(), and R2W0256.
[[nodiscard]] Outcome<Done> add_released_packages(
    const Manifest& manifest, const SourcesRequest& request, const ChannelRoots& roots,
    const ExtractLimits& limits, const std::vector<std::string>& known_names,
    std::vector<LocalPackage>& packages, WorkspaceSources& sources,
    const Cancellation& cancellation, const ProgressSink& progress);

}  // namespace ros2wasm
