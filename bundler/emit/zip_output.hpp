// Writes a site as one ZIP archive, to be deposited or handed on: of the same site the same bytes.
// Its files lie at the root of the archive, site.json first, and are stored as they are: what is
// large in a site is compressed already, or by the host.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Nothing when a site may be written to `file`: nothing is there, or an archive that emit_zip()
/// wrote. R2W0601 otherwise.
[[nodiscard]] std::optional<Diagnostic> refuse_zip(const std::filesystem::path& file);

/// R2W0609 when so many files of so many bytes are too much for an archive.
[[nodiscard]] std::optional<Diagnostic> refuse_zip_size(const std::filesystem::path& file,
                                                        std::size_t members, std::uint64_t bytes);

/// R2W0601, R2W0608 a planned path leads out of the site, R2W0609 too large for an archive,
/// R2W0211. The old archive stays until the new one is complete.
[[nodiscard]] Outcome<Done> emit_zip(const SitePlan& plan, const std::filesystem::path& file,
                                     const Cancellation& cancellation);

}  // namespace ros2wasm
