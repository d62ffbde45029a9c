// The folder that a package is compiled in is used again. Ninja decides by times what is old; times
// of files may lie: clocks jump, and copies keep the times of what they are copies of.
#pragma once

#include <filesystem>

#include "workspace_schema/outcome.hpp"

namespace ros2wasm {

/// Empties `work` when a file of `sources` has other bytes than at the last call, but a time from
/// before something in `work` was made; ninja would take what was made of it for new.
[[nodiscard]] Outcome<Done> forget_what_times_hide(const std::filesystem::path& work,
                                                   const std::filesystem::path& sources,
                                                   const std::filesystem::path& workspace);

}  // namespace ros2wasm
