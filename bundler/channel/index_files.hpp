// Finds in which form channels have their index, and brings it: the best form first. An edge,
// through the transports.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bundler/channel/transport.hpp"

namespace ros2wasm {

enum class IndexFormat { kShards, kZstd, kBzip2, kPlain };

struct IndexFile {
  std::string url;
  std::filesystem::path file;  ///< on this machine
  IndexFormat format = IndexFormat::kPlain;
};

/// For each folder of a channel ("<channel>/noarch") its index, or nothing when it has none. All
/// folders are asked at once. A mirror of a channel that has an index for one of its folders is
/// believed for the others too; where one fails, the next is asked, and the channel itself last.
/// Errors of the transports, from the last that was asked.
[[nodiscard]] std::vector<Outcome<std::optional<IndexFile>>> bring_index_files(
    std::span<const std::string> folder_urls, const ChannelRoots& roots,
    const Cancellation& cancellation);

/// The text of a repodata.json.bz2. R2W0202 when it cannot be decompressed, R2W0210.
[[nodiscard]] Outcome<std::string> bzip2_text(const std::filesystem::path& file,
                                              const std::string& url);

}  // namespace ros2wasm
