// The files of one program: those of the site below /opt/ros/DISTRO, read when they are first
// opened, and those that the program writes, which live as long as it runs. Not for several threads
// at once: who calls holds the lock (open_files.hpp).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ros2wasm {

enum class FileKind : uint8_t { kFile, kFolder, kNull, kConsole };

struct FileNode {
  std::string name;
  FileKind kind = FileKind::kFile;
  int fd = -1;  ///< of a console
  std::weak_ptr<FileNode> parent;
  std::vector<std::shared_ptr<FileNode>> children;  ///< of a folder, sorted by name
  std::string bytes;                                ///< of a file
  std::string in_site;                              ///< where its bytes are, until they are read
  uint32_t size_in_site = 0;
  uint32_t number = 0;     ///< st_ino
  int64_t changed_ns = 0;  ///< since 1970
  uint32_t mode = 0;       ///< who may do what: told to who asks, and kept to by nobody
  bool written = false;    ///< since whoever runs the site got it

  [[nodiscard]] bool is_folder() const { return kind == FileKind::kFolder; }
  [[nodiscard]] size_t size() const { return in_site.empty() ? bytes.size() : size_in_site; }
};

using File = std::shared_ptr<FileNode>;

/// The file at a path. `error` is 0 or an errno; ENOENT with a folder: only the last name is
/// missing there.
struct Found {
  int error = 0;
  File file;
  File folder;       ///< that holds it, or would
  std::string name;  ///< the last one; empty for the root
};

class FileTree {
 public:
  FileTree();

  /// A relative path starts at `from`, or where the program stands when there is none.
  [[nodiscard]] Found find(std::string_view path, const File& from = nullptr) const;
  /// The new file stands in the folder of `found`. Throws bad_alloc.
  File make(const Found& found, FileKind kind);
  void remove(const Found& found);
  /// 0, or an errno. What stands at the new place goes, when it may. Throws bad_alloc before
  /// anything changed.
  [[nodiscard]] int move(const Found& from, const Found& to);
  /// Reads it from the site if that was not done yet. 0, or an errno.
  [[nodiscard]] static int load(FileNode& file);
  [[nodiscard]] static std::string path_of(const File& file);
  /// Has whoever runs the site take a file that was closed, when it changed and stands somewhere.
  static void offer(FileNode& file, const std::string& path);
  /// Offers what stands at another place now, a file or all that is in a folder.
  static void offer_moved(const File& file);
  /// Offers all that changed and was not taken yet.
  void offer_rest() const;

  File here;                     ///< the working directory
  std::array<File, 3> consoles;  ///< what the descriptors 0 to 2 are of

 private:
  static void offer_below(FileNode& file, const std::string& path, bool moved);
  File add(const File& folder, std::string name, FileKind kind);
  File folder_at(std::string_view path);
  void add_site_files();

  uint32_t last_number_ = 0;
  File root_;
};

/// The mode of a new file.
[[nodiscard]] uint32_t usual_mode(FileKind kind);

/// ns since 1970.
[[nodiscard]] int64_t time_of_day_ns();

}  // namespace ros2wasm
