// Files of maps. See map_io.hpp.
#include "nav2_map_server/map_io.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "map_cells.hpp"
#include "map_image.hpp"
#include "map_yaml.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/LinearMath/Matrix3x3.h"
#include "tf2/LinearMath/Quaternion.h"
#include "yaml-cpp/yaml.h"

namespace nav2_map_server {
namespace {

constexpr double kDefaultOccupied = 0.65;
constexpr double kDefaultFree = 0.25;
constexpr const char* kFallbackFormat = "png";

rclcpp::Logger logger() {
  return rclcpp::get_logger("map_io");
}

std::string home_folder() {
  const char* home = std::getenv("HOME");
  return home == nullptr ? "" : home;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

/// Throws std::runtime_error when the file cannot be read or has more bytes than `most`.
std::string file_text(const std::string& path, std::size_t most) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
  if (size < 0) throw std::runtime_error("Unable to open file (" + path + ")");
  if (static_cast<std::uint64_t>(size) > most) {
    throw std::runtime_error("the file has more than " + std::to_string(most >> 20) + " MiB");
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  file.seekg(0);
  file.read(text.data(), size);
  if (!file) throw std::runtime_error("Unable to read file (" + path + ")");
  return text;
}

void write_file(const std::string& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file) throw std::runtime_error("Unable to write file (" + path + ")");
}

bool is_one_of(const std::string& format, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), format) != names.end();
}

/// `scale` needs PNG for unknown cells.
void choose_format(SaveParameters& parameters) {
  std::string& format = parameters.image_format;
  if (format.empty()) {
    format = parameters.mode == MapMode::Scale ? "png" : "pgm";
    RCLCPP_WARN_STREAM(logger(), "Image format unspecified. Setting it to: " << format);
  }
  std::transform(format.begin(), format.end(), format.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (!is_one_of(format, {"bmp", "pgm", "png"})) {
    RCLCPP_WARN_STREAM(logger(), "Requested image format '"
                                     << format
                                     << "' is not one of the recommended formats: "
                                        "'bmp', 'pgm', 'png'");
    RCLCPP_WARN_STREAM(logger(), "Format '" << format << "' is not writable. Using '"
                                            << kFallbackFormat << "' instead");
    format = kFallbackFormat;
  }
  if (parameters.mode == MapMode::Scale && format == "pgm") {
    RCLCPP_WARN_STREAM(logger(), "Map mode 'scale' requires transparency, but format '"
                                     << format
                                     << "' does not support it. Consider switching image format "
                                        "to 'png'.");
  }
}

/// Fills in defaults. Throws std::runtime_error for thresholds that contradict each other.
void check_parameters(SaveParameters& parameters) {
  if (parameters.map_file_name.empty()) {
    const double now_s = rclcpp::Clock(RCL_SYSTEM_TIME).now().seconds();
    parameters.map_file_name = "map_" + std::to_string(static_cast<int64_t>(now_s));
    RCLCPP_WARN_STREAM(logger(), "Map file unspecified. Map will be saved to "
                                     << parameters.map_file_name << " file");
  }
  if (parameters.occupied_thresh == 0.0) {
    parameters.occupied_thresh = kDefaultOccupied;
    RCLCPP_WARN_STREAM(logger(), "Occupied threshold unspecified. Setting it to default value: "
                                     << parameters.occupied_thresh);
  }
  if (parameters.free_thresh == 0.0) {
    parameters.free_thresh = kDefaultFree;
    RCLCPP_WARN_STREAM(logger(), "Free threshold unspecified. Setting it to default value: "
                                     << parameters.free_thresh);
  }
  const char* mistake = nullptr;
  if (parameters.occupied_thresh > 1.0) {
    mistake = "Threshold_occupied must be 1.0 or less";
  } else if (parameters.free_thresh < 0.0) {
    mistake = "Free threshold must be 0.0 or greater";
  } else if (parameters.occupied_thresh <= parameters.free_thresh) {
    mistake = "Threshold_free must be smaller than threshold_occupied";
  }
  if (mistake != nullptr) {
    RCLCPP_ERROR_STREAM(logger(), mistake);
    throw std::runtime_error("Incorrect thresholds");
  }
  choose_format(parameters);
}

MapPlace place_of(const nav_msgs::msg::MapMetaData& info) {
  const auto& orientation = info.origin.orientation;
  double yaw = 0;
  double pitch = 0;
  double roll = 0;
  tf2::Matrix3x3(tf2::Quaternion(orientation.x, orientation.y, orientation.z, orientation.w))
      .getEulerYPR(yaw, pitch, roll);
  return {info.resolution, info.origin.position.x, info.origin.position.y, yaw};
}

void write_map(const nav_msgs::msg::OccupancyGrid& map, const SaveParameters& parameters) {
  const auto& info = map.info;
  RCLCPP_INFO_STREAM(logger(), "Received a " << info.width << " X " << info.height << " map @ "
                                             << info.resolution << " m/pix");
  check_size(info.width, info.height);
  if (map.data.size() != static_cast<std::size_t>(info.width) * info.height) {
    throw std::runtime_error("the map has " + std::to_string(map.data.size()) + " cells");
  }
  const std::string image_file = parameters.map_file_name + "." + parameters.image_format;
  RCLCPP_INFO_STREAM(logger(), "Writing map occupancy data to " << image_file);
  write_file(image_file, written_image(image_of(map.data, info.width, info.height, parameters),
                                       parameters.image_format));
  const std::string yaml_file = parameters.map_file_name + ".yaml";
  const std::string image_name = image_file.substr(image_file.find_last_of("/\\") + 1);
  RCLCPP_INFO_STREAM(logger(), "Writing map metadata to " << yaml_file);
  write_file(yaml_file, map_yaml(image_name, place_of(info), parameters));
  RCLCPP_INFO_STREAM(logger(), "Map saved");
}

}  // namespace

std::string to_string_with_precision(double value, int precision) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(precision) << value;
  return text.str();
}

std::string expand_user_home_dir_if_needed(std::string yaml_filename, std::string home_dir) {
  if (yaml_filename.compare(0, 2, "~/") != 0) return yaml_filename;
  if (home_dir.empty()) {
    RCLCPP_INFO_STREAM(logger(),
                       "Map yaml file name starts with '~/' but no HOME variable set. \n"
                       "[INFO] [map_io] User home dir will be not expanded \n");
    return yaml_filename;
  }
  return home_dir + yaml_filename.substr(1);
}

LoadParameters loadMapYaml(const std::string& yaml_filename) {
  const std::string file = expand_user_home_dir_if_needed(yaml_filename, home_folder());
  if (!std::ifstream(file)) throw YAML::BadFile(file);
  const LoadParameters parameters = read_map_yaml(file_text(file, kMostYamlBytes), folder_of(file));
  RCLCPP_INFO_STREAM(logger(), "resolution: " << parameters.resolution);
  for (std::size_t i = 0; i < parameters.origin.size(); ++i) {
    RCLCPP_INFO_STREAM(logger(), "origin[" << i << "]: " << parameters.origin[i]);
  }
  RCLCPP_INFO_STREAM(logger(), "free_thresh: " << parameters.free_thresh);
  RCLCPP_INFO_STREAM(logger(), "occupied_thresh: " << parameters.occupied_thresh);
  RCLCPP_INFO_STREAM(logger(), "mode: " << map_mode_to_string(parameters.mode));
  RCLCPP_INFO_STREAM(logger(), "negate: " << parameters.negate);
  return parameters;
}

void loadMapFromFile(const LoadParameters& load_parameters, nav_msgs::msg::OccupancyGrid& map) {
  const std::string& file = load_parameters.image_file_name;
  RCLCPP_INFO_STREAM(logger(), "Loading image_file: " << file);
  const MapImage image = read_image(file_text(file, kMostBytes));
  nav_msgs::msg::OccupancyGrid grid;
  grid.info.width = static_cast<uint32_t>(image.width);
  grid.info.height = static_cast<uint32_t>(image.height);
  grid.info.resolution = static_cast<float>(load_parameters.resolution);
  grid.info.origin.position.x = load_parameters.origin.at(0);
  grid.info.origin.position.y = load_parameters.origin.at(1);
  grid.info.origin.orientation =
      nav2_util::geometry_utils::orientationAroundZAxis(load_parameters.origin.at(2));
  grid.data = cells_of(image, load_parameters);
  rclcpp::Clock clock(RCL_SYSTEM_TIME);
  grid.info.map_load_time = clock.now();
  grid.header.frame_id = "map";
  grid.header.stamp = clock.now();
  RCLCPP_INFO_STREAM(logger(), "Read map " << file << ": " << grid.info.width << " X "
                                           << grid.info.height << " map @ " << grid.info.resolution
                                           << " m/cell");
  map = std::move(grid);
}

LOAD_MAP_STATUS loadMapFromYaml(const std::string& yaml_file, nav_msgs::msg::OccupancyGrid& map) {
  if (yaml_file.empty()) {
    RCLCPP_ERROR_STREAM(logger(), "YAML file name is empty, can't load!");
    return MAP_DOES_NOT_EXIST;
  }
  RCLCPP_INFO_STREAM(logger(), "Loading yaml file: " << yaml_file);
  LoadParameters parameters;
  try {
    parameters = loadMapYaml(yaml_file);
  } catch (const YAML::Exception& error) {
    RCLCPP_ERROR_STREAM(logger(), "Failed processing YAML file "
                                      << yaml_file << " at position (" << error.mark.line << ":"
                                      << error.mark.column << ") for reason: " << error.what());
    return INVALID_MAP_METADATA;
  } catch (const std::exception& error) {
    RCLCPP_ERROR_STREAM(logger(), "Failed to parse map YAML loaded from file "
                                      << yaml_file << " for reason: " << error.what());
    return INVALID_MAP_METADATA;
  }
  try {
    loadMapFromFile(parameters, map);
  } catch (const std::exception& error) {
    RCLCPP_ERROR_STREAM(logger(), "Failed to load image file " << parameters.image_file_name
                                                               << " for reason: " << error.what());
    return INVALID_MAP_DATA;
  }
  return LOAD_MAP_SUCCESS;
}

bool saveMapToFile(const nav_msgs::msg::OccupancyGrid& map, const SaveParameters& save_parameters) {
  SaveParameters parameters = save_parameters;
  try {
    check_parameters(parameters);
    write_map(map, parameters);
  } catch (const std::exception& error) {
    RCLCPP_ERROR_STREAM(logger(), "Failed to write map for reason: " << error.what());
    return false;
  }
  return true;
}

}  // namespace nav2_map_server
