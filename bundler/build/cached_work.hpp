// The folder that a package is compiled in is used again. Ninja decides by times what is old; times
// of files may lie: clocks jump, and copies keep the times of what they are copies of.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Empties `work` when a file of `sources` has other bytes than at the last call, but a time from
/// before something in `work` was made; ninja would take what was made of it for new.
[[nodiscard]] Outcome<Done> forget_what_times_hide(const std::filesystem::path& work,
                                                   const std::filesystem::path& sources,
                                                   const std::filesystem::path& workspace);

/// A file of a package as the last call of forget_what_times_hide() found it.
struct SeenSource {
  std::string sha256;
  std::string path;  ///< below the package's folder
};

/// In the order of their paths. R2W0210.
[[nodiscard]] Outcome<std::vector<SeenSource>> seen_sources(const std::filesystem::path& work);

}  // namespace ros2wasm
