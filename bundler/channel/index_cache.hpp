// Copies of channels' index files that came over the network. A copy is asked after by its ETag or
// date, checked by its sha256 before use. That a channel lacks a form can be remembered for a week.
// An edge: network, disk and clock.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bundler/channel/transport.hpp"

namespace ros2wasm {

/// The state of a cached copy, stored beside it as JSON. Pure.
struct IndexCopyState {
  std::string url;  ///< without credentials
  std::string etag;
  std::string last_modified;
  std::string sha256;          ///< of the copy; empty: the channel has no such file
  std::int64_t checked_s = 0;  ///< when the server was asked last, seconds since 1970
};

[[nodiscard]] std::string write_copy_state(const IndexCopyState& state);
[[nodiscard]] std::optional<IndexCopyState> read_copy_state(std::string_view text);

/// Where the copy lies. The name holds its sha256, so that two processes never mix one's bytes with
/// the other's state.
[[nodiscard]] std::filesystem::path index_copy_place(const std::filesystem::path& folder,
                                                     const IndexCopyState& state);

/// For each address the file as it is now, or nothing when there is none; mirrors are the caller's.
/// Offline: the copy, or nothing. Errors are those of download.hpp; R2W0234 also for 401 and 403 of
/// a repodata.json; R2W0202 what came is not an index.
[[nodiscard]] std::vector<Outcome<LocalFile>> bring_indexes(std::span<const std::string> urls,
                                                            const ChannelRoots& roots,
                                                            const Cancellation& cancellation);

/// The server of `url` is not asked for it within a week.
void remember_absent(const std::string& url, const ChannelRoots& roots);

}  // namespace ros2wasm
