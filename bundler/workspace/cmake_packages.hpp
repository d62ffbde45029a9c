// What a CMakeLists.txt asks find_package() for, as far as its text tells. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/diagnostic.hpp"
#include "workspace_schema/manifest.hpp"

namespace ros2wasm {

/// Names that are REQUIRED, or without which a later command fails, in the order of the file, each
/// once, also from lists of the file that a foreach() goes through; what stands inside if() is not
/// told. `file` is only for messages.
[[nodiscard]] std::vector<Spanned<std::string>> cmake_packages(std::string_view text,
                                                               const std::string& file);

}  // namespace ros2wasm
