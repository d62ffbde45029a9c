// Definitions that stand twice on a link line. Natively the program and each shared library are
// linked apart, and the first definition is everybody's: the program's, then that of the first
// library. The linker of sites takes one definition only. An edge: reads the files of the line.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "bundler/build/link_line.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Whether the linker refused a definition as the second of its name.
[[nodiscard]] bool has_duplicates(std::string_view printed);

/// The line with copies, in `folder`, of those libraries that natively would be shared and define
/// what stands before them on the line: weak, these definitions are only taken when nobody else has
/// them. What natively is one unit (objects and static libraries of the program, one shared
/// library) is left as it is, and so are hidden definitions. `copies` becomes copy -> original;
/// empty: nothing was to do. R2W0211.
[[nodiscard]] Outcome<LinkLine> with_interposition(const LinkLine& line,
                                                   const std::filesystem::path& folder,
                                                   std::map<std::string, std::string>& copies);

}  // namespace ros2wasm
