// Packs the sources of a site (manifest, lock, packages, and the files that the manifest names)
// into one archive of the site, and unpacks them. An edge: reads and writes folders.
#pragma once

#include <filesystem>
#include <string>

#include "bundler/archive/extract_limits.hpp"
#include "bundler/pack_values.hpp"
#include "bundler/request.hpp"

namespace ros2wasm {

/// Adds the archive when the manifest asks for it (`site: sources: true`). To be called when
/// `notes` have all that the site depends on. R2W0661 for what an archive cannot hold.
[[nodiscard]] Outcome<Done> add_sources(const PackRequest& request, const BuiltWorkspace& workspace,
                                        PlanInput& input, PackNotes& notes);

/// Unpacks one into the empty `folder`; the path of the manifest there. What read_zip_files() says,
/// and R2W0221 for an archive without a manifest.
[[nodiscard]] Outcome<std::filesystem::path> unpack_sources(const std::filesystem::path& archive,
                                                            const std::filesystem::path& folder,
                                                            const ExtractLimits& limits);

}  // namespace ros2wasm
