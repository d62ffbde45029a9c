// launch.json: a launch file for bundler/render/launch_start.hpp. Pure.
#pragma once

#include <string>
#include <vector>

#include "bundler/launch/packed_launch.hpp"
#include "bundler/render/site_plan.hpp"

namespace ros2wasm {

/// `programs`: a node for each program that the site has.
[[nodiscard]] std::string packed_launch_json(const PackedLaunch& launch,
                                             const std::vector<PlannedNode>& programs);

}  // namespace ros2wasm
