// Turns a proof that nothing fits into a short tree that people can read. Pure.
#pragma once

#include <string>
#include <vector>

#include "bundler/resolve/sat_engine.hpp"
#include "bundler/resolve/solve.hpp"
#include "bundler/resolve/universe.hpp"

namespace ros2wasm {

/// One line per step: what is asked for, then indented what stands in its way.
[[nodiscard]] std::vector<std::string> explain(const ResolveRequest& request,
                                               const Universe& universe, const RepoIndex& index,
                                               const std::vector<ProofRule>& conflict);

}  // namespace ros2wasm
