// Which file of the workspace each installed Python file is. Packages install as they like, so
// files are known by their bytes. Reads the workspace, writes nothing.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "bundler/workspace/python_tree.hpp"

namespace ros2wasm {

/// Path as installed -> path of the same file in the workspace, relative to `workspace`.
using PythonSources = std::map<std::string, std::string>;

/// Modules and scripts of `installed` that some file at or below `places` is, byte for byte and by
/// its name; of several the one whose path agrees longest at its end. What was made by others (the
/// program of an entry point) and empty files are skipped.
[[nodiscard]] PythonSources python_sources(const PythonFiles& installed,
                                           const std::vector<std::filesystem::path>& places,
                                           const std::filesystem::path& workspace);

}  // namespace ros2wasm
