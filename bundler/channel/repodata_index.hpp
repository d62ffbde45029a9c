// A repodata.json as an index: it is scanned once for where the records of each name lie, and only
// the records of names that are asked for are parsed. What the scan found is kept in the cache
// directory beside the decompressed text, so that the next run maps it into memory and begins
// there.
#pragma once

#include <filesystem>
#include <memory>

#include "bundler/channel/repodata_record.hpp"
#include "bundler/channel/subdir_index.hpp"

namespace ros2wasm {

/// Where an index comes from and what its records are told of it.
struct RepodataSource {
  std::filesystem::path file;  ///< repodata.json or repodata.json.zst on this machine
  std::string url;             ///< of the index, for messages
  RecordPlace place;           ///< base_url: of the folder; `info.base_url` is put on top
};

/// Where the kept index of a file lies: `<cache>/index/<hash of its path>.index`.
[[nodiscard]] std::filesystem::path kept_index_place(const std::filesystem::path& cache,
                                                     const std::filesystem::path& source);

/// `cache`: where kept indexes lie; empty to keep none. A kept index counts only while size, time
/// and inode of `source.file` are those that it was made from, and only where its checksums hold;
/// otherwise it is made anew. R2W0202 the index cannot be read, R2W0210.
[[nodiscard]] Outcome<std::unique_ptr<SubdirIndex>> open_repodata(
    RepodataSource source, const std::filesystem::path& cache, const Cancellation& cancellation);

/// The same for a text in memory.
[[nodiscard]] Outcome<std::unique_ptr<SubdirIndex>> index_repodata(std::string_view text,
                                                                   RepodataSource source);

/// R2W0202: `why` says what the index of `url` should have.
[[nodiscard]] Diagnostic no_index(const std::string& url, std::string why);

/// Every record of one text of repodata.json. `channel` and `subdir` go into the records.
[[nodiscard]] Outcome<RepoIndex> parse_repodata(std::string_view text, const std::string& channel,
                                                const std::string& subdir);

}  // namespace ros2wasm
