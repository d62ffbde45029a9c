// The requirements for pip in the files of a Python package, as far as their text tells. Pure.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "workspace_schema/schema/manifest.hpp"

namespace ros2wasm {

/// Lines of requirements.txt ("numpy>=1.20"); not options, addresses and other files.
[[nodiscard]] std::vector<Spanned<std::string>> requirements_of_list(std::string_view text,
                                                                     const std::string& file);

/// The texts in `install_requires=[...]` of setup.py.
[[nodiscard]] std::vector<Spanned<std::string>> requirements_of_setup(std::string_view text,
                                                                      const std::string& file);

}  // namespace ros2wasm
