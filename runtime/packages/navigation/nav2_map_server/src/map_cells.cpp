// See map_cells.hpp.
#include "map_cells.hpp"

#include <array>
#include <cmath>

namespace nav2_map_server {
namespace {

constexpr std::int8_t kUnknown = -1;
constexpr std::int8_t kFree = 0;
constexpr std::int8_t kOccupied = 100;

constexpr std::uint8_t kFreePixel = 254;
constexpr std::uint8_t kUnknownPixel = 205;
constexpr std::uint8_t kOccupiedPixel = 0;

/// The cell of an opaque pixel. The numbers are floats, as upstream's.
std::int8_t cell_of(std::uint8_t gray, const LoadParameters& parameters) {
  if (parameters.mode == MapMode::Raw) {
    return gray <= kOccupied ? static_cast<std::int8_t>(gray) : kUnknown;
  }
  const float shade = static_cast<float>(gray) / 255.0F;
  const float occupancy = parameters.negate ? shade : 1.0F - shade;
  const auto free = static_cast<float>(parameters.free_thresh);
  const auto occupied = static_cast<float>(parameters.occupied_thresh);
  if (occupancy <= free) return kFree;
  if (occupancy >= occupied) return kOccupied;
  if (parameters.mode == MapMode::Trinary) return kUnknown;
  const auto range = static_cast<float>(parameters.occupied_thresh - parameters.free_thresh);
  const float percent = std::round((occupancy - free) / range * 100.0F);
  // Thresholds may be infinite or not numbers.
  const bool is_cell = percent >= 0.0F && percent <= 100.0F;
  return is_cell ? static_cast<std::int8_t>(percent) : kUnknown;
}

bool is_known(std::int8_t cell) {
  return cell >= kFree && cell <= kOccupied;
}

std::uint8_t trinary_pixel(std::int8_t cell, const SaveParameters& parameters) {
  if (!is_known(cell)) return kUnknownPixel;
  if (cell <= std::rint(parameters.free_thresh * 100.0)) return kFreePixel;
  if (cell >= std::rint(parameters.occupied_thresh * 100.0)) return kOccupiedPixel;
  return kUnknownPixel;
}

/// Upstream's image library computes with 16 bits and cuts off the fraction, twice.
std::uint8_t scale_pixel(std::int8_t cell) {
  const double shade = is_known(cell) ? (100.0 - cell) / 100.0 : 0.5;
  return static_cast<std::uint8_t>(static_cast<int>(shade * 65535.0) / 257);
}

std::uint8_t pixel_of(std::int8_t cell, const SaveParameters& parameters) {
  switch (parameters.mode) {
    case MapMode::Trinary:
      return trinary_pixel(cell, parameters);
    case MapMode::Scale:
      return scale_pixel(cell);
    case MapMode::Raw:
      break;
  }
  return is_known(cell) ? static_cast<std::uint8_t>(cell) : 255;
}

}  // namespace

std::vector<std::int8_t> cells_of(const MapImage& image, const LoadParameters& parameters) {
  std::array<std::int8_t, 256> table{};
  for (std::size_t gray = 0; gray < table.size(); ++gray) {
    table[gray] = cell_of(static_cast<std::uint8_t>(gray), parameters);
  }
  const bool has_holes = parameters.mode != MapMode::Raw && !image.alpha.empty();
  std::vector<std::int8_t> cells;
  cells.reserve(image.gray.size());
  for (std::size_t row = image.height; row-- > 0;) {
    for (std::size_t i = row * image.width; i < (row + 1) * image.width; ++i) {
      cells.push_back(has_holes && image.alpha[i] < 255 ? kUnknown : table[image.gray[i]]);
    }
  }
  return cells;
}

MapImage image_of(const std::vector<std::int8_t>& cells, std::size_t width, std::size_t height,
                  const SaveParameters& parameters) {
  MapImage image;
  image.width = width;
  image.height = height;
  image.gray.reserve(cells.size());
  const bool has_holes = parameters.mode == MapMode::Scale;
  if (has_holes) image.alpha.reserve(cells.size());
  for (std::size_t row = height; row-- > 0;) {
    for (std::size_t i = row * width; i < (row + 1) * width; ++i) {
      image.gray.push_back(pixel_of(cells[i], parameters));
      if (has_holes) image.alpha.push_back(is_known(cells[i]) ? 255 : 0);
    }
  }
  return image;
}

}  // namespace nav2_map_server
