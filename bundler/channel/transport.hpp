// How bytes of a channel reach this machine: one row per URL scheme. The next scheme is one file
// and one row.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// A file that can be read now, or nothing when the channel answers that there is no such file.
using LocalFile = std::optional<std::filesystem::path>;

struct Transport {
  std::string_view scheme;  ///< "file"; "" for a plain path; "embedded"; "https"
  /// Brings the files of these addresses to this machine and says where they are. Local ones are
  /// not copied. One outcome for each address, in their order.
  std::vector<Outcome<LocalFile>> (*bring)(std::span<const std::string> urls,
                                           const ChannelRoots& roots,
                                           const Cancellation& cancellation);
};

[[nodiscard]] std::span<const Transport> transports();

/// Each through the row of its scheme, those of one scheme at once. R2W0203 when there is none.
[[nodiscard]] std::vector<Outcome<LocalFile>> bring_all(std::span<const std::string> urls,
                                                        const ChannelRoots& roots,
                                                        const Cancellation& cancellation = {});

/// One of them. For index files: archives come through the store.
[[nodiscard]] Outcome<LocalFile> bring(const std::string& url, const ChannelRoots& roots,
                                       const Cancellation& cancellation = {});

/// Where a channel lies that is a folder of somebody's: nothing for addresses and "embedded".
[[nodiscard]] LocalFile local_channel_folder(const std::string& channel_name,
                                             const std::filesystem::path& working_directory);

}  // namespace ros2wasm
