// The wheels that a manifest names, on this machine: files beside it, and what comes from addresses
// through the cache, whose hashes are checked. An edge: disk and network.
#pragma once

#include <filesystem>
#include <vector>

#include "bundler/archive/wheel_reader.hpp"
#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/schema/lock.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

struct NamedWheel {
  LockedWheel locked;
  std::string file_name;  ///< without folders
  SourceSpan span;        ///< in the manifest
  Wheel wheel;
};

/// Those of `manifest`, sorted by project. `with_addresses`: also those that come over the network.
/// R2W0210, R2W0220 another hash than said, R2W0228, R2W0232..R2W0236, those of read_wheel();
/// R2W0243 also for another Python, and for two wheels with one file.
[[nodiscard]] Outcome<std::vector<NamedWheel>> read_wheels(const Manifest& manifest,
                                                           const ChannelRoots& roots,
                                                           const ExtractLimits& limits,
                                                           bool with_addresses,
                                                           const Cancellation& cancellation);

/// The entries of the wheels in a lock.
[[nodiscard]] std::vector<LockedWheel> locked_wheels(const std::vector<NamedWheel>& wheels);

/// Brings those of a lock that come from addresses into the cache. Errors as above.
[[nodiscard]] Outcome<Done> fetch_wheels(const std::vector<LockedWheel>& wheels,
                                         const ChannelRoots& roots,
                                         const Cancellation& cancellation);

}  // namespace ros2wasm
