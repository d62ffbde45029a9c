// When a package must be configured again. CMake reads files and takes half a second; a change in a
// C++ file is for the compiler alone. An edge to the disk.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Changes when CMake may come to another result: with other arguments, another set of files, or
/// other contents. Those of C and C++ files count only when a CMake file of the package may read
/// them itself. `work` is a folder that forget_what_times_hide() has seen. R2W0210.
[[nodiscard]] Outcome<std::string> configure_key(const std::filesystem::path& work,
                                                 const std::filesystem::path& sources,
                                                 const std::vector<std::string>& arguments);

/// Whether the last configure in `work` ended well and had this key. Then the files that it wrote
/// name this prefix from now on. If not, there is none until the next one has ended well.
[[nodiscard]] bool reuse_configure(const std::filesystem::path& work, const std::string& key,
                                   const std::filesystem::path& prefix);

/// After a configure that ended well. R2W0210, R2W0211.
[[nodiscard]] Outcome<Done> keep_configure(const std::filesystem::path& work,
                                           const std::string& key,
                                           const std::filesystem::path& prefix);

/// For when files that CMake found may be gone: the next build runs CMake again.
void forget_configure(const std::filesystem::path& work);

}  // namespace ros2wasm
