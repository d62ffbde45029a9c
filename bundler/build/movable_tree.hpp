// An installed package of a workspace as a package of a channel: a copy that names no folder of
// this machine. An edge to the disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The text that stands for the folder in which a package of a channel is unpacked.
inline constexpr const char* kMovablePrefix = "/opt/ros2wasm/installed-prefix";

struct MovableTree {
  std::string hash;                ///< of names and bytes
  bool is_compiled = false;        ///< it has code for the site's processor
  std::vector<std::string> fixed;  ///< files that name this machine all the same, sorted
};

/// The folders of this machine that a package may name.
struct BuildPlaces {
  /// The package's own prefix, those it was built with, and the environment: what is there is in
  /// the package, or in one that it needs.
  std::vector<std::filesystem::path> prefixes;
  /// Its sources, and where it was compiled: nothing of that is in a package.
  std::vector<std::filesystem::path> others;
};

/// Copies `prefix`, where `package` is installed, to the empty folder `to`. In texts each of the
/// prefixes becomes kMovablePrefix. Scripts that set up a shell and notes of the build are skipped.
/// Link kits name files of other packages by their place (R2W0505 when a file is in no package).
[[nodiscard]] Outcome<MovableTree> make_movable(const std::filesystem::path& prefix,
                                                const std::string& package,
                                                const BuildPlaces& places,
                                                const std::filesystem::path& to);

}  // namespace ros2wasm
