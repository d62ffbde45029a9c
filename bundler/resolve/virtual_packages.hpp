// Features of the platform, as packages that no channel has (CEP 30): `__unix` and `__archspec` for
// emscripten-wasm32. Pure.
#pragma once

#include <vector>

#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// Each has an empty channel and file name: that is how they are known.
[[nodiscard]] std::vector<PackageRecord> virtual_packages();

[[nodiscard]] inline bool is_virtual(const PackageRecord& record) {
  return record.file_name.empty();
}

}  // namespace ros2wasm
