// Paths with `*`, `?` and `[letters]`, and the files of a launch world that they stand for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

[[nodiscard]] bool is_file_pattern(std::string_view path);

/// Sorted. As a shell takes them: no sign stands for `/`, nor for a dot at the begin of a name.
/// `path` is absolute.
[[nodiscard]] std::vector<std::string> matching_paths(const std::string& path,
                                                      const LaunchWorld& world);

}  // namespace ros2wasm
