// Packages that ask for a newer CMake than the machine has. CMake refuses them in
// cmake_minimum_required(), before any file of ours is read; so a copy of the package is configured
// that asks for no more than there is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "bundler/build/compile_errors.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

struct NewerCMake {
  Diagnostic warning;  ///< R2W0529; its place is below the package's folder
  std::string there;   ///< the version of this machine's CMake
};

/// When CMake's output says that it is too old for the package.
[[nodiscard]] std::optional<NewerCMake> asks_for_newer_cmake(std::string_view cmake_output,
                                                             const BuildPlace& place);

/// The text of a CMake file that asks for `there` where it asked for more. Its lines stay. Pure.
[[nodiscard]] std::string for_older_cmake(const std::string& text, std::string_view there);

/// Copies what seen_sources() knows of the package to a folder beside `work`, which it gives. What
/// was there is gone; files have the times of the package's. R2W0211.
[[nodiscard]] Outcome<std::filesystem::path> copy_for_older_cmake(
    const std::filesystem::path& work, const std::filesystem::path& source, std::string_view there);

}  // namespace ros2wasm
