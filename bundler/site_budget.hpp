// Holds a planned site to `site: budget:`, against ros2wasm.sizes beside the lock. An edge: reads
// and writes that file.
#pragma once

#include <filesystem>

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

inline constexpr const char* kSizesFileName = "ros2wasm.sizes";

/// R2W0660 when it is over its budget. Else `folder` has its sizes, with `write`, when there is a
/// budget.
[[nodiscard]] Outcome<Done> keep_budget(const Manifest& manifest, const SitePlan& plan,
                                        const std::filesystem::path& folder, bool write);

}  // namespace ros2wasm
