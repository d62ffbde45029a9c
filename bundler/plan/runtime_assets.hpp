// The built runtime that goes into every site: runtime_assets.json and the files beside it. An
// edge: reads files.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/plan/site_plan.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// Reads and checks all files against their sizes and hashes. R2W0604 the list or a file is
/// damaged.
[[nodiscard]] Outcome<std::vector<RuntimeAsset>> read_runtime_assets(
    const std::filesystem::path& list);

}  // namespace ros2wasm
