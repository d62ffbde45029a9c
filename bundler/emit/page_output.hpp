// Writes a site as one HTML page that runs from a double click: of the same site the same bytes.
#pragma once

#include <filesystem>
#include <optional>

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Nothing when a site may be written to `file`: nothing is there, or a page that emit_page()
/// wrote. R2W0601 otherwise.
[[nodiscard]] std::optional<Diagnostic> refuse_page(const std::filesystem::path& file);

/// R2W0601, R2W0608 a planned path leads out of the site, R2W0609 too much for a page, R2W0211.
/// The old page stays until the new one is complete.
[[nodiscard]] Outcome<Done> emit_page(const SitePlan& plan, const std::filesystem::path& file,
                                      const Cancellation& cancellation);

}  // namespace ros2wasm
