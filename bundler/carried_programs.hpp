// Programs that a site includes although nothing starts them: those that the manifest names under
// `programs`.
#pragma once

#include "bundler/launch_from_file.hpp"
#include "bundler/pack_values.hpp"

namespace ros2wasm {

/// Adds those that are not there yet. R2W0401, R2W0402, R2W0405 as for nodes; R2W0402 for a package
/// without programs.
[[nodiscard]] Outcome<Done> add_programs(const Manifest& manifest, const BuiltPackages& built,
                                         LaunchedFile& launched);

}  // namespace ros2wasm
