// A file as bytes in memory, read by the system when they are looked at. An edge to the disk.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Distinguishes one state of a file from the next: a writer renames a new file into place or at
/// least changes its time.
struct FileIdentity {
  std::uint64_t size = 0;
  std::int64_t modified_ns = 0;
  std::uint64_t inode = 0;

  bool operator==(const FileIdentity&) const = default;
};

/// R2W0210.
[[nodiscard]] Outcome<FileIdentity> identity_of(const std::filesystem::path& path);

class MappedFile {
 public:
  MappedFile() = default;  ///< no bytes
  /// R2W0210.
  [[nodiscard]] static Outcome<MappedFile> open(const std::filesystem::path& path);
  ~MappedFile();
  MappedFile(MappedFile&& other) noexcept;
  MappedFile& operator=(MappedFile&& other) noexcept;

  /// Valid as long as this object; nobody may shorten the file meanwhile.
  [[nodiscard]] std::string_view bytes() const { return {data_, size_}; }

 private:
  const char* data_ = nullptr;
  std::size_t size_ = 0;
};

}  // namespace ros2wasm
