// Which launch file of a workspace without a manifest starts it. Pure: paths in, a choice out.
#pragma once

#include <string>
#include <vector>

namespace ros2wasm {

struct BringupChoice {
  std::string file;                     ///< empty: nothing tells which
  std::vector<std::string> candidates;  ///< the others, in their order
};

/// `files`: launch files of the packages, relative to the workspace, with `/`. The only one; else
/// the only one whose name, or whose package's, says `bringup`.
[[nodiscard]] BringupChoice bringup_file(const std::vector<std::string>& files);

}  // namespace ros2wasm
