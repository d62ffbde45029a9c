// Frames of LZ4, as chunks of MCAP files may have them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rosbag2_storage::mcap {

/// Throws Damaged when `frames` make anything but `size` bytes, of which memory is made at once.
[[nodiscard]] std::string unpack_lz4(std::string_view frames, size_t size);

}  // namespace rosbag2_storage::mcap
