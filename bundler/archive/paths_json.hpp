// A package's description of its files: info/paths.json has their hashes; packages from before 2017
// have only lists of names. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

enum class PathKind { kFile, kLink, kDirectory };
enum class PrefixMode { kNone, kText, kBinary };

struct PathEntry {
  PathKind kind = PathKind::kFile;
  std::string sha256;  ///< of the file, or of what the link leads to; may be empty in old packages
  std::uint64_t size = 0;
  bool size_known = false;
  std::string placeholder;  ///< the prefix that the file was made for
  PrefixMode mode = PrefixMode::kNone;
};

/// The texts of these files of info/, as far as they are there.
struct PackageLists {
  std::optional<std::string> paths_json;
  std::optional<std::string> files;       ///< a path a line
  std::optional<std::string> has_prefix;  ///< a path a line, or placeholder, mode and path

  /// Else only the archive as a whole has a hash.
  [[nodiscard]] bool has_hashes() const { return paths_json.has_value(); }
};

/// By path; info/files and info/has_prefix where there is no info/paths.json, as conda has it.
/// R2W0221 when that cannot be read, names a path that leads outside, or nothing is there. `name`
/// is for messages.
[[nodiscard]] Outcome<std::map<std::string, PathEntry>> package_paths(const PackageLists& lists,
                                                                      const std::string& name);

}  // namespace ros2wasm
