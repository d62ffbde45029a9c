// The lists of files of an unpacked package. An edge to the disk.
#pragma once

#include <filesystem>

#include "bundler/archive/paths_json.hpp"

namespace ros2wasm {

/// R2W0210 when one of them is there but cannot be read.
[[nodiscard]] Outcome<PackageLists> read_package_lists(const std::filesystem::path& folder);

}  // namespace ros2wasm
