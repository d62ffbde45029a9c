// Python modules of the channels whose packages have other names, or need more than they do for
// C++. One table.
#pragma once

#include <string_view>
#include <vector>

namespace ros2wasm {

/// The package that brings a top-level module, as package.xml names it: mostly of the same name.
[[nodiscard]] std::string_view package_of_module(std::string_view module);

/// Packages that a module needs and that its package does not depend on, so that workspaces without
/// Python need not include them.
[[nodiscard]] std::vector<std::string_view> needs_of_module(std::string_view module);

}  // namespace ros2wasm
