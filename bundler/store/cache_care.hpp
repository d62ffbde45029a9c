// Looks after the cache directory: how large it is, whether what lies there is still right, and
// what can go. An edge to the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// One folder of the cache: "packages", "archives", "index", "shards", "environments", "build" ...
struct CacheArea {
  std::string name;
  std::uint64_t files = 0;
  std::uint64_t bytes = 0;  ///< hard links are counted in each place
};

struct CacheFault {
  std::string path;  ///< relative to the cache directory
  std::string reason;
};

struct CacheCheck {
  std::uint64_t checked = 0;  ///< packages, archives, shards, indexes and kept indexes
  std::vector<CacheFault> faults;
};

struct PruneRequest {
  bool everything = false;  ///< the whole cache, also what is good
};

struct Pruned {
  std::uint64_t entries = 0;
  std::uint64_t bytes = 0;
};

/// Keeps what lies in the cache apart from what the cache may lie in: a workspace, whose packages
/// its packages are not, and a project of npm, whose package.json may call all scripts modules,
/// which Pyodide's are not. R2W0211.
[[nodiscard]] Outcome<Done> mark_cache(const std::filesystem::path& cache);

/// Sorted by name. R2W0210.
[[nodiscard]] Outcome<std::vector<CacheArea>> measure_cache(const std::filesystem::path& cache);

/// Reads everything that has a hash: every file of every package against its paths.json, archives
/// and shards against the sha256 in their names, indexes against their state, kept indexes
/// (repodata_index.hpp) against their checksums. R2W0210, R2W0903.
[[nodiscard]] Outcome<CacheCheck> check_cache(const std::filesystem::path& cache,
                                              const Cancellation& cancellation);

/// Removes what nobody needs: leftovers of runs that were ended (older than an hour), archives that
/// are unpacked, old copies of indexes, kept indexes of anything but the copies in use, builds and
/// launch files of other versions of ros2wasm, launch files that nobody has asked for in a month,
/// and whatever is damaged. R2W0211.
[[nodiscard]] Outcome<Pruned> prune_cache(const std::filesystem::path& cache,
                                          const PruneRequest& request,
                                          const Cancellation& cancellation);

}  // namespace ros2wasm
