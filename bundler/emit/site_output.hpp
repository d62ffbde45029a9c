// Where a site goes: into a folder or, when the name ends in .zip or .html, into one archive or
// page.
#pragma once

#include <filesystem>
#include <optional>

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Nothing when a site may be written there: nothing is there yet, or a site that ros2wasm made.
/// R2W0601 otherwise. Asked before anything is built.
[[nodiscard]] std::optional<Diagnostic> refuse_output(const std::filesystem::path& output);

/// As refuse_output(), which is not asked when nothing is written. How a site at `output` names the
/// store: relative to itself, empty without one. R2W0614 when it cannot.
[[nodiscard]] Outcome<std::string> may_write(const std::filesystem::path& output,
                                             const std::filesystem::path& store, bool plan_only);

/// Writes the site with emit_folder(), emit_zip() or emit_page(), with their errors.
[[nodiscard]] Outcome<Done> emit_site(const SitePlan& plan, const std::filesystem::path& output,
                                      const Cancellation& cancellation);

}  // namespace ros2wasm
