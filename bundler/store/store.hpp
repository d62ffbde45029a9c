// The content-addressed store of unpacked packages: verified, atomic, safe for many processes at
// once.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bundler/archive/package_reader.hpp"
#include "bundler/channel/channel_index.hpp"
#include "workspace_schema/cancellation.hpp"
#include "workspace_schema/outcome.hpp"
#include "workspace_schema/package_record.hpp"
#include "workspace_schema/progress_event.hpp"

namespace ros2wasm {

/// $XDG_CACHE_HOME/ros2wasm, else $HOME/.cache/ros2wasm. `home` and `xdg_cache_home` are the
/// variables' values.
[[nodiscard]] std::filesystem::path default_cache_directory(const std::string& xdg_cache_home,
                                                            const std::string& home);

class Store {
 public:
  /// `roots.cache` is made when first needed.
  explicit Store(ChannelRoots roots, ExtractLimits limits = {});

  /// The directory with the package's files and its info/ (read-only; never write there). Brings
  /// the archive, checks its sha256 and every file's, unpacks beside and renames. Cached the second
  /// time, with a check. R2W0220 wrong sha256 or size, R2W0221..R2W0227 see package_reader.hpp,
  /// R2W0228 the archive is not there.
  [[nodiscard]] Outcome<std::filesystem::path> unpacked(
      const PackageRecord& record, const Cancellation& cancellation = {}) const;

  [[nodiscard]] const ChannelRoots& roots() const { return roots_; }

 private:
  ChannelRoots roots_;
  ExtractLimits limits_;
};

}  // namespace ros2wasm
