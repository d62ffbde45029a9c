// The packages that a CMakeLists.txt asks find_package() for, and its own name, as far as its text
// shows them. Pure.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/base/diagnostic.hpp"
#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Names that are REQUIRED, or without which a later command fails, in the order of the file, each
/// once, also from lists of the file that a foreach() goes through; what stands inside if() is not
/// told. `file` is only for messages.
[[nodiscard]] std::vector<Spanned<std::string>> cmake_packages(std::string_view text,
                                                               const std::string& file);

/// The arguments of project().
struct CMakeProject {
  Spanned<std::string> name;
  std::string version;  ///< may be empty
};

/// The first project() with a name that the text tells: letters, digits, `_`, `-`, `+` and `.`.
[[nodiscard]] std::optional<CMakeProject> cmake_project(std::string_view text,
                                                        const std::string& file);

}  // namespace ros2wasm
