// Reading and writing files: the edge to the disk. Errors are values: R2W0210 cannot read, R2W0211
// cannot write (both say what the system said). Nothing here knows what the bytes mean.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Limits of read_file() in bytes, by who writes such files: people (manifests, package.xml,
/// CMakeLists.txt), programs (locks, lists, indexes, sources that are generated), and anybody (what
/// is copied whole into a site or a package).
inline constexpr std::uint64_t kMostOfText = std::uint64_t{16} << 20U;
inline constexpr std::uint64_t kMostOfList = std::uint64_t{256} << 20U;
inline constexpr std::uint64_t kMostOfData = std::uint64_t{16} << 30U;

/// The whole file as bytes. Only regular files are read: a pipe would block, a device never end.
/// R2W0210, also when it has more than `at_most` bytes.
[[nodiscard]] Outcome<std::string> read_file(const std::filesystem::path& path,
                                             std::uint64_t at_most);

/// No entry has this name. A link that leads nowhere or to itself, a folder, a pipe and what cannot
/// be looked at are not absent: read_file() says why they cannot be read. For a file that may
/// be missing (a manifest, a course, a lock) this decides, so that a broken one is never skipped.
[[nodiscard]] bool is_absent(const std::filesystem::path& path);

/// Opens for reading what read_file() would read, and gives its descriptor, which the caller
/// closes. R2W0210.
[[nodiscard]] Outcome<int> open_file_to_read(const std::filesystem::path& path,
                                             std::uint64_t at_most = kMostOfData);

/// Writes beside and renames, so that readers see the old bytes or the new ones, never half. Parent
/// directories are made. Writes nothing when the file has these bytes already. R2W0211.
[[nodiscard]] Outcome<Done> write_file(const std::filesystem::path& path, std::string_view bytes);

/// `mkdir -p`. R2W0211.
[[nodiscard]] Outcome<Done> make_directories(const std::filesystem::path& path);

/// The path from the root of the file system; links are not followed. R2W0210: it is empty, or it
/// is relative and the current folder has been removed.
[[nodiscard]] Outcome<std::filesystem::path> absolute_path(const std::filesystem::path& path);

/// As absolute_path(), with the links followed of what exists of it.
[[nodiscard]] Outcome<std::filesystem::path> real_path(const std::filesystem::path& path);

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
/// bytes. Links are not followed. What somebody else removes meanwhile is not listed. R2W0210.
[[nodiscard]] Outcome<std::vector<TreeEntry>> list_tree(const std::filesystem::path& root);

/// The real path of `path`, with all links followed; nothing when that is not in `root` or nothing
/// is there. What strangers made is read by this: a link must not lead to the reader's own files.
[[nodiscard]] std::optional<std::filesystem::path> path_within(const std::filesystem::path& root,
                                                               const std::filesystem::path& path);

/// The longest name of a file in most file systems, in bytes.
inline constexpr std::size_t kLongestName = 255;

/// A new empty directory `<parent>/<prefix>XXXXXX` which removes itself, unless it was renamed
/// away. Of a long prefix only the beginning is taken.
class TemporaryDirectory {
 public:
  [[nodiscard]] static Outcome<TemporaryDirectory> make(const std::filesystem::path& parent,
                                                        const std::string& prefix);
  /// In the system's folder for temporary files.
  [[nodiscard]] static Outcome<TemporaryDirectory> make(const std::string& prefix);
  ~TemporaryDirectory();
  TemporaryDirectory(TemporaryDirectory&& other) noexcept;
  TemporaryDirectory& operator=(TemporaryDirectory&& other) noexcept;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryDirectory(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

/// Diagnostics of this file, for the other edges to the disk. `errno_value` gives the reason.
[[nodiscard]] Diagnostic cannot_read(const std::filesystem::path& path, std::string reason);
[[nodiscard]] Diagnostic cannot_read(const std::filesystem::path& path, int errno_value);
[[nodiscard]] Diagnostic cannot_write(const std::filesystem::path& path, int errno_value);

}  // namespace ros2wasm
