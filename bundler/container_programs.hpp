// Containers of launch files with components of several packages: which they are is known when the
// launch file is evaluated, so they are linked then.
#pragma once

#include "bundler/launch_from_file.hpp"
#include "bundler/pack_values.hpp"

namespace ros2wasm {

/// Links the containers among the nodes, which get the programs. R2W0504, R2W0505.
[[nodiscard]] Outcome<Done> link_containers(const BuiltPackages& built, LaunchedFile& launched,
                                            const Cancellation& cancellation,
                                            const ProgressSink& progress);

}  // namespace ros2wasm
