// Writes a file piece by piece beside its place and renames it at the end: readers see the old file
// or the whole new one. An edge to the disk.
#pragma once

#include <filesystem>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

class ReplacedFile {
 public:
  /// Parent directories are made. R2W0211.
  [[nodiscard]] static Outcome<ReplacedFile> begin(const std::filesystem::path& path);
  ~ReplacedFile();  ///< without finish() nothing is left
  ReplacedFile(ReplacedFile&& other) noexcept;
  ReplacedFile& operator=(ReplacedFile&& other) noexcept;

  /// At the end. R2W0211.
  [[nodiscard]] Outcome<Done> append(std::string_view bytes);
  /// Over what is there at the beginning. R2W0211.
  [[nodiscard]] Outcome<Done> overwrite_front(std::string_view bytes);
  /// R2W0211.
  [[nodiscard]] Outcome<Done> finish();

 private:
  explicit ReplacedFile(std::filesystem::path path) : path_(std::move(path)) {}

  std::filesystem::path path_;
  std::filesystem::path beside_;
  int file_ = -1;
};

}  // namespace ros2wasm
