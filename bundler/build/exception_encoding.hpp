// Translates programs from the exception encoding that Emscripten 3.1.6 writes to the one of
// WebAssembly 3.0
// (`site: exceptions: standard` in the manifest), with binaryen's wasm-opt.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "workspace_schema/base/cancellation.hpp"
#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// Results are kept in `cache` by the program's hash. R2W0509 when wasm-opt is missing or fails.
[[nodiscard]] Outcome<std::string> with_standard_exceptions(std::string_view program,
                                                            const std::filesystem::path& executable,
                                                            const std::filesystem::path& cache,
                                                            const Cancellation& cancellation);

}  // namespace ros2wasm
