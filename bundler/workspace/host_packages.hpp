// The names in package.xml files that ask for nothing from a channel: tools of the build machine,
// test and launch tooling. One table, so that people can read what is taken for granted.
#pragma once

#include <string_view>

namespace ros2wasm {

/// Why `name` needs nothing, or an empty text when it must come from a channel or the workspace.
[[nodiscard]] std::string_view host_package_reason(std::string_view name);

}  // namespace ros2wasm
