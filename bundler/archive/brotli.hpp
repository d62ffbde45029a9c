// Brotli, whole buffers. The library ends in brotli.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// As small as it gets. The same bytes on every machine with one version of the library.
[[nodiscard]] std::string brotli_compressed(std::string_view bytes);

/// R2W0202 when damaged, or when more than `limit_bytes` would come out; `name` is for messages.
[[nodiscard]] Outcome<std::string> brotli_unpacked(std::string_view bytes,
                                                   std::uint64_t limit_bytes,
                                                   const std::string& name);

}  // namespace ros2wasm
