// Pictures of files and of cameras.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace ros2wasm_sim {

/// Rows from the top; red, green and blue, a byte each.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

/// Reads PNG, JPEG, BMP and TGA files of at most 4096 x 4096 pixels. Nothing when the bytes are not
/// one of these.
std::optional<Picture> read_picture(const std::string& bytes);

/// A JPEG file; `quality` from 1 to 100.
std::vector<std::uint8_t> jpeg_of(const Picture& picture, int quality);

}  // namespace ros2wasm_sim
