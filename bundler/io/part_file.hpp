// A file that is being downloaded: `<place>.part` beside its place, held by one process at a time,
// so that the next process can go on where one was ended.
#pragma once

#include <filesystem>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

class PartFile {
 public:
  /// `<place>.part`; when another process holds that, a new file of a name of its own, which goes
  /// away unless finish() was called. R2W0211.
  [[nodiscard]] static Outcome<PartFile> open(const std::filesystem::path& place);
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&& other) noexcept;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// True when its contents may be the beginning of the file.
  [[nodiscard]] bool resumable() const { return fd_ >= 0; }
  /// Gives it its place. R2W0211.
  [[nodiscard]] Outcome<Done> finish(const std::filesystem::path& place);

 private:
  PartFile(std::filesystem::path path, int fd) : path_(std::move(path)), fd_(fd) {}
  std::filesystem::path path_;
  int fd_ = -1;  ///< with the lock
};

}  // namespace ros2wasm
