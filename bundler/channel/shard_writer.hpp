// Writes the sharded form of a subdirectory's index (CEP 16): one file for each package name, named
// by its own sha256, and one small file that says which there are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/outcome.hpp"
#include "workspace_schema/package_record.hpp"

namespace ros2wasm {

/// Writes `<folder>/shards/<sha256>.msgpack.zst` and `<folder>/repodata_shards.msgpack.zst`, and
/// takes away shards that nothing names any more. The same records give the same bytes: the time of
/// writing is left out. R2W0210.
[[nodiscard]] Outcome<Done> write_shards(const std::filesystem::path& folder,
                                         const std::string& subdir,
                                         const std::vector<PackageRecord>& records);

}  // namespace ros2wasm
