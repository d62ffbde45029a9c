// Packages that neither the workspace, its sources nor a channel has, from the release repositories
// of a ROS distribution (`distribution:` of `sources:`). Reads the lock, the disk and, unless it is
// offline, the network.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "bundler/workspace_sources.hpp"
#include "workspace_schema/schema/distribution_file.hpp"

namespace ros2wasm {

/// The packages of a distribution file, which is on this machine or on the web. A list from the web
/// names nothing that only this user can read. R2W0210, R2W0232 to R2W0236, R2W0253 it is not here
/// and may not be fetched, R2W0256.
[[nodiscard]] Outcome<std::map<std::string, ReleasedPackage>> read_distribution(
    const std::string& place, const ChannelRoots& roots, const Cancellation& cancellation);

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
