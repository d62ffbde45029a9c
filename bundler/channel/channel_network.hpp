// Settings of the network and of channels' addresses: the base of bare names, mirrors, credentials.
// Pure: addresses and variables in, addresses out.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bundler/io/download.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The credentials for reading below an address. They are never written to a file or a message.
struct ChannelSecret {
  std::string base;       ///< "https://host/channel", without credentials
  std::string user_info;  ///< "user:password" as in an address
  std::string token;      ///< goes into the path as `/t/TOKEN`
};

struct ChannelMirrors {
  std::string base;               ///< what the manifest and the lock name
  std::vector<std::string> urls;  ///< asked first, in this order; folders are absolute paths
};

struct ChannelNetwork {
  bool offline = false;  ///< what is not on this machine is not there
  std::string alias;     ///< what bare names of channels are below; empty: nothing
  std::vector<ChannelMirrors> mirrors;
  std::vector<ChannelSecret> secrets;
  std::map<std::string, std::string> variables;  ///< of the environment
  DownloadSettings download;
};

/// From the environment: ROS2WASM_CHANNEL_ALIAS, NETRC, SSL_CERT_FILE, ROS2WASM_RETRIES,
/// ROS2WASM_STALL_SECONDS.
[[nodiscard]] ChannelNetwork network_of(std::map<std::string, std::string> variables);

/// A channel's name as it goes into records and locks, without credentials: "conda-forge" is
/// alias + "/conda-forge"; folders ("./x", "/x"), addresses and "embedded" stay. `${NAME}` is
/// replaced by the variable (R2W0237 when there is none); credentials go into `network`.
[[nodiscard]] Outcome<std::string> channel_address(std::string_view text, ChannelNetwork& network);

/// True for names that stand for an address below the alias, and may also be a folder's.
[[nodiscard]] bool is_bare_channel_name(std::string_view text);

/// "http" and "https".
[[nodiscard]] bool is_network_url(std::string_view url);

/// The same file or folder at the mirrors of its channel, in their order, without credentials.
[[nodiscard]] std::vector<std::string> at_mirrors(const std::string& url,
                                                  const ChannelNetwork& network);

/// The address with what its server wants to know.
[[nodiscard]] DownloadSource source_of(const std::string& url, const ChannelNetwork& network);

/// All addresses that a file may be brought from, with credentials: mirrors first. Mirrors that are
/// folders are not among them.
[[nodiscard]] std::vector<DownloadSource> sources_of(const std::string& url,
                                                     const ChannelNetwork& network);

}  // namespace ros2wasm
