// Where the cache is, and that nobody else can write there: packages are taken from it on the word
// of files that are in it too.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// $XDG_CACHE_HOME/ros2wasm, else .cache/ros2wasm in $HOME or, without that, in the home folder
/// that the system knows of the user. `variables` are those of the environment. Makes the folder,
/// for this user alone, where that can be. R2W0244 there is no such place, or it is another user's,
/// or others may write there.
[[nodiscard]] Outcome<std::filesystem::path> cache_directory(
    const std::map<std::string, std::string>& variables);

}  // namespace ros2wasm
