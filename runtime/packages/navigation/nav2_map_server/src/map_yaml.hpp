// The YAML file of a map, as text.
#pragma once

#include <cstddef>
#include <string>

#include "nav2_map_server/map_parameters.hpp"

namespace nav2_map_server {

/// The limit for the YAML file of a map.
constexpr std::size_t kMostYamlBytes = std::size_t{1} << 20;

/// An image without a leading `/` is in `folder`. Throws YAML::Exception for what is missing or not
/// of its type, std::invalid_argument for a mode that does not exist.
LoadParameters read_map_yaml(const std::string& text, const std::string& folder);

/// Metres, metres and radians of the lower left cell.
struct MapPlace {
  double resolution = 0;
  double x = 0;
  double y = 0;
  double yaw = 0;
};

std::string map_yaml(const std::string& image_name, const MapPlace& place,
                     const SaveParameters& parameters);

}  // namespace nav2_map_server
