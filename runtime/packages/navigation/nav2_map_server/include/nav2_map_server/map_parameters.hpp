// How a map is read from files, and saved to files.
#pragma once

#include <string>
#include <vector>

#include "nav2_map_server/map_mode.hpp"

namespace nav2_map_server {

struct LoadParameters {
  std::string image_file_name;
  double resolution{0};                 ///< m/cell
  std::vector<double> origin{0, 0, 0};  ///< of the lower left cell: x [m], y [m], yaw [rad]
  double free_thresh{0};                ///< of 1: cells up to it are free
  double occupied_thresh{0};            ///< of 1: cells from it on are occupied
  MapMode mode{MapMode::Trinary};
  bool negate{false};  ///< white is occupied, not black
};

struct SaveParameters {
  std::string map_file_name{""};  ///< without an ending
  std::string image_format{""};
  double free_thresh{0.0};  ///< 0: the default
  double occupied_thresh{0.0};
  MapMode mode{MapMode::Trinary};
};

}  // namespace nav2_map_server
