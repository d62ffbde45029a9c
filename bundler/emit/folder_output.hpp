// Writes a site as a folder: beside its place, then renamed, so that a failure leaves the old one
// untouched.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "bundler/render/site_plan.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Nothing when a site may be written to `folder`: it is not there, is empty, or holds a site that
/// ros2wasm made. R2W0601 otherwise. Asked before anything is built.
[[nodiscard]] std::optional<Diagnostic> refuse_folder(const std::filesystem::path& folder);

/// R2W0602 when `needed` bytes do not fit on a disk with `available`.
[[nodiscard]] std::optional<Diagnostic> refuse_size(const std::filesystem::path& folder,
                                                    std::uint64_t needed, std::uint64_t available);

/// Beside a site that has a store: what the site of that name was when it had this sha256.
[[nodiscard]] std::string earlier_folder(const std::string& name, const std::string& sha256);

/// R2W0601, R2W0602, R2W0608 a planned path leads out of the site, R2W0211 (with the system's
/// reason).
[[nodiscard]] Outcome<Done> emit_folder(const SitePlan& plan, const std::filesystem::path& folder,
                                        const Cancellation& cancellation);

}  // namespace ros2wasm
