// Reads what a conda archive says of itself, without unpacking it.
#pragma once

#include <filesystem>
#include <string>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// The text of info/index.json of a .conda or .tar.bz2 file. R2W0221 when there is none.
[[nodiscard]] Outcome<std::string> read_index_json(const std::filesystem::path& archive,
                                                   const std::string& name);

}  // namespace ros2wasm
