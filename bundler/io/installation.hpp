// Where the program's own data lies: beside the binary in a build tree, under share/ros2wasm after
// install.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// A file or folder of the installation, such as "templates/toolchain/ros2wasm-toolchain.cmake" or
/// "runtime/runtime_assets.json". R2W0912 when the installation has none; `what` names it for
/// people.
[[nodiscard]] Outcome<std::filesystem::path> find_own_data(const std::filesystem::path& executable,
                                                           std::string_view relative,
                                                           std::string_view what);

/// A tool that came through npm, such as "wasm-opt": in the node_modules folder beside or above the
/// binary, or above `share/ros2wasm`.
[[nodiscard]] std::optional<std::filesystem::path> find_npm_tool(
    const std::filesystem::path& executable, std::string_view name);

}  // namespace ros2wasm
