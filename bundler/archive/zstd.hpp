// Zstandard, whole buffers. libzstd ends in zstd.cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "workspace_schema/base/outcome.hpp"

namespace ros2wasm {

/// One frame with its size and a checksum. The same bytes on every machine with one libzstd.
[[nodiscard]] std::string zstd_compressed(std::string_view bytes, int level);

/// All frames of `bytes`. R2W0202 when damaged or when more than `limit_bytes` would come out;
/// `name` is for messages.
[[nodiscard]] Outcome<std::string> zstd_decompressed(std::string_view bytes,
                                                     std::uint64_t limit_bytes,
                                                     const std::string& name);

/// The same piece by piece, so that the whole never is in memory. What `take` says ends it.
[[nodiscard]] Outcome<Done> zstd_decompress(
    std::string_view bytes, std::uint64_t limit_bytes, const std::string& name,
    const std::function<Outcome<Done>(std::string_view)>& take);

}  // namespace ros2wasm
