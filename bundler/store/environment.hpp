// A prefix with the files of many packages, as conda would install them, for CMake and the pack to
// read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/store/store.hpp"
#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/base/progress_event.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// A file that two packages bring with different bytes. The later package in install order won.
struct OverwrittenFile {
  std::string path;
  std::string winner;  ///< distribution names
  std::string loser;
};

struct Environment {
  std::filesystem::path prefix;
  std::string
      key;  ///< hash of the record list: the same packages give the same key on every machine
  std::vector<OverwrittenFile> overwritten;  ///< sorted by path; empty when it came from the cache
  /// Distribution names of packages whose files have no hashes of their own; empty likewise.
  std::vector<std::string> without_hashes;
  bool cached = false;
};

/// Makes (or finds) the environment in the store's cache: `<cache>/environments/<key>`. A found one
/// is read whole and made anew when a file is not what it was. Read-only:
/// install your own files elsewhere. `records` in install order. Placeholders become the prefix;
/// files of `noarch: python` go where python_packages.hpp says (R2W0242). R2W0231 when one package
/// has a folder where another has a file or a link.
[[nodiscard]] Outcome<Environment> make_environment(const Store& store,
                                                    const std::vector<PackageRecord>& records,
                                                    const Cancellation& cancellation = {},
                                                    const ProgressSink& progress = {});

/// The key that make_environment would use.
[[nodiscard]] std::string environment_key(const std::vector<PackageRecord>& records);

}  // namespace ros2wasm
