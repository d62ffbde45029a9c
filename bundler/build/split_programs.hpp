// Programs go into sites without their function names; the names stay beside them for crash
// reports.
#pragma once

#include <filesystem>
#include <string>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Moves the function names of the programs in lib/<package>/ of `prefix` into files of their own:
/// `talker.names` beside `talker.wasm`.
[[nodiscard]] Outcome<Done> split_programs(const std::filesystem::path& prefix,
                                           const std::string& package);

}  // namespace ros2wasm
