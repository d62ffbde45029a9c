// Reads the compiled programs of a site: an edge to the disk.
#pragma once

#include <vector>

#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"

namespace ros2wasm {

/// The bytes of the nodes' compiled programs, and the names of their functions, into `input`.
[[nodiscard]] Outcome<Done> read_programs(const PackRequest& request,
                                          const BuiltWorkspace& workspace,
                                          const std::vector<LaunchNode>& nodes, PlanInput& input,
                                          const Cancellation& cancellation);

}  // namespace ros2wasm
