// One process at a time: an exclusive lock on a file, for folders that are built in place.
#pragma once

#include <filesystem>

namespace ros2wasm {

/// Held until it goes out of scope; waits for other processes.
class FileLock {
 public:
  explicit FileLock(const std::filesystem::path& file);
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  ~FileLock();
  /// False when the lock could not be had: no permission, or a signal came.
  [[nodiscard]] bool held() const { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

}  // namespace ros2wasm
