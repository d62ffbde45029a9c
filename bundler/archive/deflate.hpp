// Deflate, whole buffers, without a header. zlib ends in deflate.cpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// As small as it gets. The same bytes on every machine with one zlib.
[[nodiscard]] std::string deflated(std::string_view bytes);

/// The same with the header of gzip, which has no time and no name.
[[nodiscard]] std::string gzipped(std::string_view bytes);

/// The inverse of gzipped(). Limits and errors are those of inflated().
[[nodiscard]] Outcome<std::string> gunzipped(std::string_view bytes, std::uint64_t limit_bytes,
                                             const std::string& name);

/// R2W0202 when damaged, or when more than `limit_bytes` would come out; `name` is for messages.
[[nodiscard]] Outcome<std::string> inflated(std::string_view bytes, std::uint64_t limit_bytes,
                                            const std::string& name);

}  // namespace ros2wasm
