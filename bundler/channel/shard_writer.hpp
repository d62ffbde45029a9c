// The sharded form of a subdirectory's index (CEP 16): one file for each package name, named
// by its own sha256, and one small file that says which there are.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// One file of a subdirectory's index.
struct IndexPart {
  std::string path;  ///< relative to the subdirectory
  std::string bytes;
};

/// `shards/<sha256>.msgpack.zst` of each name, then `repodata_shards.msgpack.zst`, to be written in
/// this order. The same records give the same bytes: the time of writing is skipped. Pure.
[[nodiscard]] std::vector<IndexPart> shard_parts(const std::string& subdir,
                                                 const std::vector<PackageRecord>& records);

/// Takes away shards in `folder` that are none of `parts`.
void remove_stale_shards(const std::filesystem::path& folder, const std::vector<IndexPart>& parts);

}  // namespace ros2wasm
