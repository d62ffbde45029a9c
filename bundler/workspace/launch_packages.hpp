// Which packages a launch file names, as far as its text tells. Pure; nothing is evaluated here.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Does `ros2 launch` offer a file of this name, or do launch files include such ones?
[[nodiscard]] bool is_launch_file_name(std::string_view name);

/// Packages of nodes (`package='a'`, `pkg="a"`, `pkg: a`) and those that are looked up
/// (`FindPackageShare('a')`, `$(find-pkg-share a)`), in the order of the file, each once. What a
/// variable names is not told. `file` is only for messages.
[[nodiscard]] std::vector<Spanned<std::string>> launch_packages(std::string_view text,
                                                                const std::string& file);

}  // namespace ros2wasm
