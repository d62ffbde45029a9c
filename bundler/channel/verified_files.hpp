// Files whose hash is known before they come: archives of packages and shards of indexes. Each has
// one place in the cache; what lies there is checked before it is used. An edge: network and disk.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bundler/channel/channel_network.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct WantedFile {
  std::string what;             ///< for messages: "the archive of `libfoo-1.0-0`"
  std::string url;              ///< without credentials
  std::filesystem::path place;  ///< where it lies afterwards
  std::uint64_t size = 0;       ///< 0: not known
  std::string sha256;           ///< hex; empty: by md5
  std::string md5;
};

/// Why the file is not the wanted one; nothing when it is. R2W0220, R2W0210.
[[nodiscard]] std::optional<Diagnostic> file_fault(const WantedFile& wanted,
                                                   const std::filesystem::path& file);

/// Brings all of them from folders that are mirrors, or over the network at once; `done` is called
/// for each as it ends (with its position), `tick` several times a second, both on this thread.
/// Errors: R2W0228 not there, R2W0220 not the right one, R2W0232 offline, those of download.hpp.
void bring_verified(const std::vector<WantedFile>& wanted, const ChannelNetwork& network,
                    const Cancellation& cancellation,
                    const std::function<void(std::size_t, Outcome<Done>)>& done,
                    const std::function<void(const DownloadProgress&)>& tick = {});

/// A file of unknown hash, to be locked.
struct NewFile {
  std::string what;             ///< for messages: "the model `Coke`"
  std::string url;              ///< without credentials
  std::filesystem::path place;  ///< where it lies afterwards
  std::uint64_t limit_bytes = 0;
  std::string asked_header;  ///< as in TransferRequest
};

/// Brings the file from the first mirror that has it, else from its server, and gives the value of
/// the header, if there was one. R2W0228 not there, R2W0232 offline, those of download.hpp.
[[nodiscard]] Outcome<std::string> bring_new(const NewFile& wanted, const ChannelNetwork& network,
                                             const Cancellation& cancellation);

}  // namespace ros2wasm
