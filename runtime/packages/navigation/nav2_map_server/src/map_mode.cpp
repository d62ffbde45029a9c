// See map_mode.hpp.
#include "nav2_map_server/map_mode.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace nav2_map_server {

const char* map_mode_to_string(MapMode map_mode) {
  switch (map_mode) {
    case MapMode::Trinary:
      return "trinary";
    case MapMode::Scale:
      return "scale";
    case MapMode::Raw:
      return "raw";
  }
  throw std::invalid_argument("map_mode");
}

MapMode map_mode_from_string(std::string map_mode_name) {
  std::transform(map_mode_name.begin(), map_mode_name.end(), map_mode_name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const MapMode mode : {MapMode::Trinary, MapMode::Scale, MapMode::Raw}) {
    if (map_mode_name == map_mode_to_string(mode)) return mode;
  }
  throw std::invalid_argument("map_mode_name");
}

}  // namespace nav2_map_server
