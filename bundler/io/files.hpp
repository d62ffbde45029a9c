// Reading and writing files: the edge to the disk. Errors are values: R2W0210 cannot read, R2W0211
// cannot write (both say what the system said). Nothing here knows what the bytes mean.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// The whole file as bytes. R2W0210.
[[nodiscard]] Outcome<std::string> read_file(const std::filesystem::path& path);

/// Writes beside and renames, so that readers see the old bytes or the new ones, never half. Parent
/// directories are made. Writes nothing when the file has these bytes already. R2W0211.
[[nodiscard]] Outcome<Done> write_file(const std::filesystem::path& path, std::string_view bytes);

/// `mkdir -p`. R2W0211.
[[nodiscard]] Outcome<Done> make_directories(const std::filesystem::path& path);

/// Removes a file or a whole tree, read-only directories too; absent is fine. R2W0211.
[[nodiscard]] Outcome<Done> remove_tree(const std::filesystem::path& path);

enum class FileKind { kFile, kLink, kDirectory, kOther };

struct TreeEntry {
  std::string path;  ///< relative to the root, with `/`
  FileKind kind = FileKind::kFile;
  bool executable = false;  ///< of a file: somebody may run it
  std::uint64_t size = 0;   ///< of a file
  std::string link_target;  ///< of a link, as it is written in it
};

/// All files, links and other things below `root` (directories only when empty), sorted by path as
/// bytes. Links are not followed. R2W0210.
[[nodiscard]] Outcome<std::vector<TreeEntry>> list_tree(const std::filesystem::path& root);

/// The real path of `path`, with all links followed; nothing when that is not in `root` or nothing
/// is there. What strangers made is read by this: a link must not lead to the reader's own files.
[[nodiscard]] std::optional<std::filesystem::path> path_within(const std::filesystem::path& root,
                                                               const std::filesystem::path& path);

/// A new empty directory `<parent>/<prefix>XXXXXX` which removes itself, unless it was renamed
/// away.
class TemporaryDirectory {
 public:
  [[nodiscard]] static Outcome<TemporaryDirectory> make(const std::filesystem::path& parent,
                                                        const std::string& prefix);
  ~TemporaryDirectory();
  TemporaryDirectory(TemporaryDirectory&& other) noexcept;
  TemporaryDirectory& operator=(TemporaryDirectory&& other) noexcept;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryDirectory(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// Diagnostics of this file, for the other edges to the disk. `errno_value` gives the reason.
[[nodiscard]] Diagnostic cannot_read(const std::filesystem::path& path, int errno_value);
[[nodiscard]] Diagnostic cannot_write(const std::filesystem::path& path, int errno_value);

}  // namespace ros2wasm
