// info/paths.json of a package: which files it has and what they must hash to. Pure.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "workspace_schema/outcome.hpp"

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

/// By path. R2W0221 when it cannot be read or names a path that leads outside. `name` is for
/// messages.
[[nodiscard]] Outcome<std::map<std::string, PathEntry>> parse_paths_json(std::string_view text,
                                                                         const std::string& name);

}  // namespace ros2wasm
