// Reads and writes occupancy grids: a YAML file beside an image.
#pragma once

#include <string>

#include "nav2_map_server/map_mode.hpp"
#include "nav2_map_server/map_parameters.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"

namespace nav2_map_server {

typedef enum {
  LOAD_MAP_SUCCESS,
  MAP_DOES_NOT_EXIST,
  INVALID_MAP_METADATA,
  INVALID_MAP_DATA
} LOAD_MAP_STATUS;

/// Throws YAML::Exception for what the file lacks, std::invalid_argument for an unknown mode.
LoadParameters loadMapYaml(const std::string& yaml_filename);
/// Throws std::exception when the image cannot be used.
void loadMapFromFile(const LoadParameters& load_parameters, nav_msgs::msg::OccupancyGrid& map);
/// Logs what is wrong.
LOAD_MAP_STATUS loadMapFromYaml(const std::string& yaml_file, nav_msgs::msg::OccupancyGrid& map);

/// Writes `<map_file_name>.<image_format>` and `<map_file_name>.yaml`. False: the reason is logged.
bool saveMapToFile(const nav_msgs::msg::OccupancyGrid& map, const SaveParameters& save_parameters);

std::string to_string_with_precision(double value, int precision);
/// Puts `home_dir` in place of a leading `~`, unless it is empty.
std::string expand_user_home_dir_if_needed(std::string yaml_filename, std::string home_dir);

}  // namespace nav2_map_server
