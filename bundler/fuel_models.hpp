// Models of Gazebo Fuel for the simulator of a site (`fuel:` of `simulation:`). Reads the lock, the
// disk and, unless it is offline, the network.
#pragma once

#include <vector>

#include "bundler/workspace/share_tree.hpp"
#include "bundler/workspace_sources.hpp"

namespace ros2wasm {

/// Adds to `sources` the models that files of the packages name, and in turn those that these
/// models name, as the lock has them or as Fuel has them now. If the manifest does not allow it, a
/// warning for each: R2W0532. R2W0536 Fuel does not have it, or it is not a model; R2W0311 it is
/// not in the lock as it must be; else errors of bring_source_trees() and bring_new().
[[nodiscard]] Outcome<Done> add_fuel_models(const Manifest& manifest, const SourcesRequest& request,
                                            const ChannelRoots& roots, const ExtractLimits& limits,
                                            const std::vector<LocalPackage>& packages,
                                            WorkspaceSources& sources, Diagnostics& warnings,
                                            const Cancellation& cancellation,
                                            const ProgressSink& progress);

/// Adds the files of these models, where the simulator finds them. Others of `trees` are skipped.
[[nodiscard]] Outcome<Done> collect_fuel_models(const std::vector<SourceTree>& trees,
                                                SharedFiles& into);

}  // namespace ros2wasm
