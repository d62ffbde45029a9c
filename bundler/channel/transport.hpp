// How bytes of a channel reach this machine: one row per URL scheme. The next scheme is one file
// and one row.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/cancellation.hpp"
#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// A file that can be read now, or nothing when the channel answers that there is no such file.
using LocalFile = std::optional<std::filesystem::path>;

struct Transport {
  std::string_view scheme;  ///< "file"; "" for a plain path; "embedded"
  /// Brings the file of `url` to this machine and says where it is. A local one is not copied.
  Outcome<LocalFile> (*bring)(const std::string& url, const ChannelRoots& roots,
                              const Cancellation& cancellation);
};

[[nodiscard]] std::span<const Transport> transports();

/// Through the row of the URL's scheme. R2W0203 when there is none.
[[nodiscard]] Outcome<LocalFile> bring(const std::string& url, const ChannelRoots& roots,
                                       const Cancellation& cancellation = {});

/// "embedded" -> "embedded:", "./dir/" -> "./dir", the base that "/noarch/repodata.json" is put
/// behind.
[[nodiscard]] std::string channel_base_url(std::string_view channel_name);

}  // namespace ros2wasm
