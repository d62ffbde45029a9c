// Whether something that a launch file in Python looked at is as it was. An edge: reads files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/launch/host/launch_world.hpp"

namespace ros2wasm {

/// `path` and `state` as SeenPaths has them; a path that ends in `/` has the names in a folder.
/// Sees what templates/python/mounted_files.mjs shows: nothing hidden, no link that leads out.
[[nodiscard]] bool is_still(const std::vector<LaunchFolder>& folders, const std::string& path,
                            std::string_view state);

}  // namespace ros2wasm
