// The sources that a manifest names, on this machine: git repositories and archives through the
// cache, as the lock has them, and folders as they are. An edge: disk, network and processes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/archive/extract_limits.hpp"
#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"
#include "workspace_schema/schema/lock.hpp"
#include "workspace_schema/schema/named_source.hpp"

namespace ros2wasm {

/// The folder of a workspace that has sources which a site carried: below it, one for each commit
/// or hash of an archive.
inline constexpr const char* kCarriedSources = "ros2wasm_sources";

struct SourceTree {
  NamedSource entry;
  LockedSource locked;                ///< empty for a folder, which no lock holds
  std::filesystem::path folder;       ///< absolute
  bool can_change = false;            ///< it is a folder of the user's
  bool is_new = false;                ///< it came now
  bool is_carried = false;            ///< it is in kCarriedSources, and may lack what was not built
  std::vector<std::string> left_out;  ///< links that lead out of it, which it has no more
};

struct SourceTreesRequest {
  std::vector<NamedSource> entries;  ///< of the manifest; .repos files are read here
  std::vector<LockedSource> locked;  ///< the entries that the lock has
  bool must_be_locked = false;       ///< a source that is not among them is an error
  /// The files of kCarriedSources take the place of those that would be fetched, unchecked.
  bool takes_carried = false;
};

/// The identity of a locked source: its commit, or the hash of its archive.
[[nodiscard]] std::string key_of(const LockedSource& source);

/// A folder of a source in the cache.
[[nodiscard]] std::filesystem::path source_place(const std::filesystem::path& cache,
                                                 const std::string& key);

/// An archive of a source in the cache.
[[nodiscard]] std::filesystem::path source_archive_place(const std::filesystem::path& cache,
                                                         const std::string& sha256);

/// Why what lies at a source_place() is not what it should be; empty when it is.
[[nodiscard]] std::string source_fault(const std::filesystem::path& place);

/// One for each source, in the order of the manifest. R2W0210, R2W0250 a .repos file, R2W0251 and
/// R2W0252 of git, R2W0253 it is not on this machine and may not be fetched, R2W0254 what is in it
/// is not taken, R2W0311 it is not in the lock as it must be, R2W0220 to R2W0225 of archives.
[[nodiscard]] Outcome<std::vector<SourceTree>> bring_source_trees(const SourceTreesRequest& request,
                                                                  const ChannelRoots& roots,
                                                                  const ExtractLimits& limits,
                                                                  const Cancellation& cancellation,
                                                                  const ProgressSink& progress);

/// Brings all that a lock names into the cache. Errors as above.
[[nodiscard]] Outcome<Done> fetch_source_trees(const std::vector<LockedSource>& sources,
                                               const ChannelRoots& roots,
                                               const ExtractLimits& limits,
                                               const Cancellation& cancellation);

}  // namespace ros2wasm
