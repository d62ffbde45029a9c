// From pixels to the cells of a grid and back. Cells are in rows from the bottom.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "map_image.hpp"
#include "nav2_map_server/map_parameters.hpp"

namespace nav2_map_server {

std::vector<std::int8_t> cells_of(const MapImage& image, const LoadParameters& parameters);

/// `cells` has width * height values. In the mode `scale`, the image has transparency.
MapImage image_of(const std::vector<std::int8_t>& cells, std::size_t width, std::size_t height,
                  const SaveParameters& parameters);

}  // namespace nav2_map_server
