// The meaning of the pixels of a map.
#pragma once

#include <string>

namespace nav2_map_server {

enum class MapMode {
  Trinary,  ///< occupied, free or unknown, by two thresholds
  Scale,    ///< from free to occupied between the thresholds; transparent pixels are unknown
  Raw,      ///< 0 to 100 as they are; all others are unknown
};

/// Throws std::invalid_argument for a value that is not a mode.
const char* map_mode_to_string(MapMode map_mode);
/// Small and capital letters are the same. Throws std::invalid_argument for a name of no mode.
MapMode map_mode_from_string(std::string map_mode_name);

}  // namespace nav2_map_server
