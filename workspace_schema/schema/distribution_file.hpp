// Distribution files of rosdistro (REP 141, REP 143): which packages a ROS distribution has
// released, and the tags that have their sources. Pure.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct ReleasedPackage {
  std::string url;      ///< of the release repository
  std::string tag;      ///< `release/jazzy/nav2_map_server/1.3.7-1`
  std::string version;  ///< `1.3.7-1`
};

/// By package name. Repositories that are not released, or not in git, are skipped. R2W0256: not
/// such a file; `file` is for messages.
[[nodiscard]] Outcome<std::map<std::string, ReleasedPackage>> read_distribution_file(
    std::string_view text, const std::string& file);

}  // namespace ros2wasm
