// Makes channels: puts packages into a channel folder and writes its index.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/archive/conda_writer.hpp"
#include "bundler/channel/shard_writer.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// Writes the package to `<channel>/<subdir>/` and returns the archive's path. The index is not
/// touched.
[[nodiscard]] Outcome<std::filesystem::path> add_to_channel(
    const std::filesystem::path& channel, const CondaPackage& package,
    const std::filesystem::path& staged_prefix);

/// Puts a finished archive into `<channel>/<subdir>/`, the subdirectory that it names itself.
/// R2W0205, R2W0221.
[[nodiscard]] Outcome<std::filesystem::path> copy_to_channel(const std::filesystem::path& channel,
                                                             const std::filesystem::path& archive);

/// The whole index of a subdirectory: shards, repodata.json.zst, repodata.json, in the order in
/// which they are written so that a reader at any moment finds all that its index names. The same
/// records in the same order give the same bytes. Pure.
[[nodiscard]] std::vector<IndexPart> index_parts(const std::string& subdir,
                                                 const std::vector<PackageRecord>& records);

/// Which archives are read for an index: all, or those which have changed since the last one (see
/// known_archives.hpp).
enum class Reading { kChanged, kAll };

struct ChannelSummary {
  std::size_t packages = 0;
  std::size_t read = 0;  ///< archives that had to be read
  std::vector<std::string> subdirs;
};

/// Takes info/index.json of every archive and writes repodata.json, repodata.json.zst and shards of
/// `noarch` and of each other subdirectory that holds packages. The same archives give the same
/// bytes. R2W0221 an archive is damaged, R2W0205 its metadata does not fit its place.
[[nodiscard]] Outcome<ChannelSummary> index_channel(const std::filesystem::path& channel,
                                                    Reading reading = Reading::kChanged);

}  // namespace ros2wasm
