// Reads the index of every channel: which packages there are. An edge: it reads files through the
// transports.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "bundler/channel/channel_network.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"
#include "workspace_schema/conda/channel_priority.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// The folder of a channel that has what runs in sites.
inline constexpr const char* kSitePlatform = "emscripten-wasm32";

/// The name of the channel inside the program.
inline constexpr const char* kEmbeddedChannel = "embedded";

/// Where relative and embedded channels lie, and where downloads may be kept.
struct ChannelRoots {
  std::filesystem::path working_directory;  ///< of the manifest: base of relative folders
  std::filesystem::path embedded;           ///< the embedded channel; see embedded_channel()
  std::filesystem::path cache;              ///< Store's cache directory
  ChannelNetwork network{};                 ///< credentials come from channel_addresses()
  std::string platform = kSitePlatform;     ///< read beside noarch
};

/// One channel as the manifest or the command line names it: "embedded", "./dir", "/dir",
/// "file:///dir", "https://host/name", "conda-forge", "conda-forge/label/dev".
struct ChannelSource {
  std::string name;
  std::optional<SourceSpan> span;  ///< for messages
};

/// A record that could not be used, and why. It does not stop the run.
struct LeftOutRecord {
  std::string channel;
  std::string subdir;
  std::string file_name;
  std::string reason;
};

struct RepoIndex {
  std::vector<std::string> channels;   ///< in the order of priority
  std::vector<PackageRecord> records;  ///< in no order that matters
  std::vector<LeftOutRecord> left_out;
  /// Packages that are there without any channel: those that the workspace builds. Without file
  /// names.
  std::vector<PackageRecord> built_here = {};
  /// The names of all packages of the channels, sorted; there may be fewer records. For explaining
  /// what is missing; may be empty.
  std::function<std::vector<std::string>()> names;
  /// Which of these names another platform has: "linux-64 in CHANNEL". Reads more of the channels,
  /// so it is for explaining what is missing; may be empty.
  std::function<std::map<std::string, std::string>(std::span<const std::string> names)> elsewhere;
};

/// Channels whose lists of names are known; records are read when they are asked for.
class OpenChannels {
 public:
  /// Names of all packages, sorted.
  [[nodiscard]] const std::vector<std::string>& names() const;

  /// The names of the channels, in the order of priority.
  [[nodiscard]] std::vector<std::string> channels() const;

  /// All records that a solution of these match specs can use: those of the names in the specs, of
  /// the names that those depend on, and so on. Texts that are not valid match specs are skipped.
  [[nodiscard]] Outcome<RepoIndex> reachable(std::span<const std::string> specs,
                                             ChannelPriority priority,
                                             const Cancellation& cancellation = {}) const;

  /// Every record there is, with every spec checked.
  [[nodiscard]] Outcome<RepoIndex> everything(const Cancellation& cancellation = {}) const;

 private:
  friend Outcome<OpenChannels> open_channels(std::span<const ChannelSource> channels,
                                             const ChannelRoots& roots,
                                             const Cancellation& cancellation,
                                             const ProgressSink& progress);
  struct State;
  std::shared_ptr<State> state_;
};

/// The channels by the names that go into records and locks: each once, a folder by its first
/// spelling, without credentials, which go into `roots.network`. A bare name is a folder beside the
/// manifest when there is one, else an address below the alias. R2W0237.
[[nodiscard]] Outcome<std::vector<ChannelSource>> channel_addresses(
    std::span<const ChannelSource> channels, ChannelRoots& roots);

/// Where a match spec names a channel (`channel::name`) that is none of `addresses`, it comes
/// behind the others, as conda has it. The spec then names it as the list does: without
/// credentials, which go into `roots.network`, so that it can be shown and locked. Texts that are
/// no match specs are passed over. R2W0237, R2W0240, R2W0303 the channel cannot be told from the
/// text.
[[nodiscard]] Outcome<Done> add_named_channel(std::string& spec,
                                              const std::optional<SourceSpan>& span,
                                              std::vector<ChannelSource>& addresses,
                                              ChannelRoots& roots);

/// Opens the folders of the platform and `noarch` of every channel, named as channel_addresses()
/// says, in the best form that it has: shards, repodata.json.zst, .bz2, repodata.json. R2W0201 the
/// channel is not there, R2W0202 its index cannot be read, R2W0203 nobody speaks its scheme,
/// R2W0232 not on this machine and offline, R2W0233..R2W0237 the network.
[[nodiscard]] Outcome<OpenChannels> open_channels(std::span<const ChannelSource> channels,
                                                  const ChannelRoots& roots,
                                                  const Cancellation& cancellation = {},
                                                  const ProgressSink& progress = {});

/// open_channels() and everything().
[[nodiscard]] Outcome<RepoIndex> load_channels(std::span<const ChannelSource> channels,
                                               const ChannelRoots& roots,
                                               const Cancellation& cancellation = {},
                                               const ProgressSink& progress = {});

/// The channel that ships with the program: `<exe dir>/channel`, then `<exe
/// dir>/../share/ros2wasm/channel`. R2W0204 when neither is there.
[[nodiscard]] Outcome<std::filesystem::path> embedded_channel(
    const std::filesystem::path& executable);

}  // namespace ros2wasm
