// One process at a time: an exclusive lock on a file, for folders that are built in place.
#pragma once

#include <filesystem>
#include <optional>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Held until it goes out of scope.
class FileLock {
 public:
  /// Waits for other processes. R2W0211 the file cannot be made or locked.
  [[nodiscard]] static Outcome<FileLock> take(const std::filesystem::path& file,
                                              const Cancellation& cancellation);
  /// Locks an existing folder; nothing when another process has the lock, or the folder is missing.
  /// `is_shared`: others may have a shared lock too.
  [[nodiscard]] static std::optional<FileLock> of_folder(const std::filesystem::path& folder,
                                                         bool is_shared = false);
  /// Waits until nobody has the folder, or with `is_shared` until nobody has it alone. Nothing
  /// where the file system does not lock folders. R2W0210 the folder is not there.
  [[nodiscard]] static Outcome<std::optional<FileLock>> take_folder(
      const std::filesystem::path& folder, bool is_shared, const Cancellation& cancellation);
  /// Nothing when another process has it, or the file cannot be made.
  [[nodiscard]] static std::optional<FileLock> try_take(const std::filesystem::path& file);
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;
  ~FileLock();

 private:
  explicit FileLock(int fd) : fd_(fd) {}
  int fd_ = -1;
};

}  // namespace ros2wasm
