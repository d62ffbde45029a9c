// Notices that somebody changed a file of a workspace. Looks at names, sizes and times, never at
// contents: packing is what finds out whether a change matters.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ros2wasm {

struct FileMark {
  std::uint64_t size = 0;
  std::uint64_t inode = 0;
  std::int64_t modified_ns = 0;

  bool operator==(const FileMark&) const = default;
};

/// Every file of the workspace by its path.
using WorkspaceMarks = std::map<std::string, FileMark>;

/// `roots` are files and folders. Hidden folders, folders that hold COLCON_IGNORE (as colcon's
/// build, install and log do) and `ignored` ones are skipped; links to folders are followed, each
/// folder once.
[[nodiscard]] WorkspaceMarks workspace_marks(const std::vector<std::filesystem::path>& roots,
                                             const std::vector<std::filesystem::path>& ignored);

/// Compares looks at a workspace. Pure, so that it needs no clock: the caller looks now and then.
class WorkspaceWatch {
 public:
  explicit WorkspaceWatch(WorkspaceMarks packed) : packed_(std::move(packed)), last_(packed_) {}

  /// The first changed path, once a whole interval passed without further changes: an editor or
  /// `git checkout` may write many files. The changes then count as packed.
  [[nodiscard]] std::optional<std::string> look(WorkspaceMarks now);

  /// Files that the pack itself wrote: as they are now, they are no change.
  void accept(const WorkspaceMarks& written);

 private:
  WorkspaceMarks packed_;
  WorkspaceMarks last_;
};

}  // namespace ros2wasm
