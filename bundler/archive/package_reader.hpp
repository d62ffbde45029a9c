// Unpacks conda archives (.conda and .tar.bz2) safely. libarchive ends in archive_library.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "bundler/archive/extract_limits.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct UnpackedPackage {
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;
};

/// Unpacks the archive into `directory` (which must be empty) and checks every file against
/// info/paths.json, or, in an old package without it, that info/files lists it. On an error the
/// caller removes `directory`; nothing was written outside. `name` is for messages. R2W0221 damaged
/// or not a conda archive, R2W0222 a name that leads outside (absolute, `..`), R2W0223 a link that
/// leads outside, R2W0224 two members with one name or names that differ in letter case only,
/// R2W0225 over a limit, R2W0226 files that differ from paths.json. Link scripts are files like
/// others.
[[nodiscard]] Outcome<UnpackedPackage> unpack_package(const std::filesystem::path& archive,
                                                      const std::filesystem::path& directory,
                                                      const std::string& name,
                                                      const ExtractLimits& limits,
                                                      const Cancellation& cancellation = {});

}  // namespace ros2wasm
