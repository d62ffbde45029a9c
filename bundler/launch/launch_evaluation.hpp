// From a launch file to what it comes to with some launch arguments. Pure but for what the world's
// functions read.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "bundler/launch/launch_description.hpp"
#include "bundler/launch/launch_scope.hpp"

namespace ros2wasm {

/// Follows includes of any language that is read. `given`: launch arguments by name; `from`: where
/// the file is named, if it is. All faults at once: R2W0410 to R2W0414, R2W0416, and those of the
/// files' syntax.
[[nodiscard]] Outcome<LaunchDescription> evaluate_launch(
    const std::string& path, const std::map<std::string, std::string>& given,
    const LaunchWorld& world, const std::optional<SourceSpan>& from = std::nullopt);

}  // namespace ros2wasm
