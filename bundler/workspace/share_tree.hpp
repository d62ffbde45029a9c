// The files of installed packages that programs may want to read when they run. An edge: reads
// folders and files.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Bytes by path below the prefix: "share/demo/config/gains.yaml".
using SharedFiles = std::map<std::string, std::string>;

/// Whether a file directly in share/<package>/ sets up a shell (`local_setup.sh`, `package.dsv`).
/// Environment hooks are in folders: they are read for launch files.
[[nodiscard]] bool sets_up_shell(const std::filesystem::path& name);

/// Adds what `package` has in share/<package>/ of `prefix` and its own resources in the ament
/// index, without what only builds need (CMake files, shell hooks, interface definitions) and
/// without what cannot come along, of which it says for people what and why. A file that is known
/// stays. R2W0210.
[[nodiscard]] Outcome<std::vector<std::string>> collect_shared_files(
    const std::filesystem::path& prefix, const std::string& package, SharedFiles& into);

}  // namespace ros2wasm
