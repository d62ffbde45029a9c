// Packages of channels that others have made: whether their compiled files can be a part of this
// site. Most say what they were made with in their record (`emscripten-abi`, `python_abi`), and the
// solver compares it; some say nothing. An edge to the disk.
#pragma once

#include <vector>

#include "bundler/store/store.hpp"
#include "workspace_schema/base/outcome.hpp"
#include "workspace_schema/conda/package_record.hpp"

namespace ros2wasm {

/// R2W0534 for each package, not of the embedded channel, with objects that cannot be linked into
/// programs of a site (threads, exceptions, another machine), with modules for another Python, or
/// with modules that a site may not load. The packages are in the store. R2W0210.
[[nodiscard]] Outcome<Done> check_foreign_packages(const std::vector<PackageRecord>& records,
                                                   const Store& store);

}  // namespace ros2wasm
