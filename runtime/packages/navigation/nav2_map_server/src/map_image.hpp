// An image of a map in memory, and the formats of its files. Knows no disk and no messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace nav2_map_server {

/// A map of 290 by 290 m at 5 cm.
constexpr std::size_t kMostPixels = std::size_t{1} << 25;
/// The limit for an image file, and for the samples in it.
constexpr std::size_t kMostBytes = std::size_t{1} << 26;

/// Rows from the top.
struct MapImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> gray;
  /// 255 is opaque. Empty: the image has no transparency.
  std::vector<std::uint8_t> alpha;
};

/// The lightness of a colour, from samples of 16 bits (weights 0.299, 0.587, 0.114).
constexpr std::uint8_t lightness(std::uint32_t red, std::uint32_t green, std::uint32_t blue) {
  return static_cast<std::uint8_t>(((306 * red + 601 * green + 117 * blue) >> 10) / 257);
}

/// Throws std::runtime_error when an image of that size has more than kMostPixels, or none.
void check_size(std::size_t width, std::size_t height);

/// Reads PGM, PPM or PBM (P1 to P6), PNG or BMP, recognised by their first bytes. Throws
/// std::runtime_error for any other and for a broken one.
MapImage read_image(const std::string& bytes);
/// One of the three portable formats.
MapImage read_pnm(const std::string& bytes);
/// PNG or BMP.
MapImage read_picture(const std::string& bytes);

/// The file's bytes. `format` is pgm, png or bmp; transparency is only in PNG.
std::string written_image(const MapImage& image, const std::string& format);
std::string written_picture(const MapImage& image, bool is_png);

}  // namespace nav2_map_server
