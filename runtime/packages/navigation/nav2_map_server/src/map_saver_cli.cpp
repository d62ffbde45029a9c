// map_saver_cli: saves the map of a topic to files, once.
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "nav2_map_server/map_mode.hpp"
#include "nav2_map_server/map_saver.hpp"
#include "rclcpp/rclcpp.hpp"

namespace {

using nav2_map_server::MapMode;
using nav2_map_server::SaveParameters;

constexpr const char* kUsage =
    "Usage:\n"
    "  map_saver_cli [arguments] [--ros-args ROS remapping args]\n"
    "\n"
    "Arguments:\n"
    "  -h/--help\n"
    "  -t <map_topic>\n"
    "  -f <mapname>\n"
    "  --occ <threshold_occupied>\n"
    "  --free <threshold_free>\n"
    "  --fmt <image_format>\n"
    "  --mode trinary(default)/scale/raw\n"
    "\n"
    "NOTE: --ros-args should be passed at the end of command line\n";

/// Upstream's `return -1`, as a shell sees it.
constexpr int kFailed = 255;

struct Request {
  std::string topic = "map";
  SaveParameters parameters;
  bool is_help = false;
};

MapMode mode_of(const rclcpp::Logger& logger, const std::string& word) {
  try {
    return nav2_map_server::map_mode_from_string(word);
  } catch (const std::invalid_argument&) {
    RCLCPP_WARN(logger, "Map mode parameter not recognized: %s, using default value (trinary)",
                word.c_str());
    return MapMode::Trinary;
  }
}

/// False: an option is unknown, or the value of the last one is missing.
bool parse(const rclcpp::Logger& logger, const std::vector<std::string>& words, Request& request) {
  SaveParameters& parameters = request.parameters;
  for (size_t i = 0; i < words.size() && words[i] != "--ros-args"; ++i) {
    const std::string& option = words[i];
    if (option == "-h" || option == "--help") {
      request.is_help = true;
      return true;
    }
    const bool is_known = option == "-t" || option == "-f" || option == "--occ" ||
                          option == "--free" || option == "--fmt" || option == "--mode";
    if (!is_known) {
      RCLCPP_ERROR(logger, "Wrong argument: %s", option.c_str());
      return false;
    }
    if (++i == words.size()) {
      RCLCPP_ERROR(logger, "Wrong argument: %s should be followed by a value.", option.c_str());
      return false;
    }
    const std::string& value = words[i];
    if (option == "-t") request.topic = value;
    if (option == "-f") parameters.map_file_name = value;
    if (option == "--occ") parameters.occupied_thresh = std::atof(value.c_str());
    if (option == "--free") parameters.free_thresh = std::atof(value.c_str());
    if (option == "--fmt") parameters.image_format = value;
    if (option == "--mode") parameters.mode = mode_of(logger, value);
  }
  return true;
}

int save(const rclcpp::Logger& logger, const Request& request) {
  try {
    const auto saver = std::make_shared<nav2_map_server::MapSaver>();
    saver->on_configure(rclcpp_lifecycle::State());
    return saver->saveMapTopicToFile(request.topic, request.parameters) ? 0 : 1;
  } catch (const std::exception& error) {
    RCLCPP_ERROR(logger, "Unexpected problem appear: %s", error.what());
    return kFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const rclcpp::Logger logger = rclcpp::get_logger("map_saver_cli");
  Request request;
  int code = kFailed;
  if (parse(logger, std::vector<std::string>(argv + 1, argv + argc), request)) {
    if (request.is_help) std::fputs(kUsage, stdout);
    code = request.is_help ? 0 : save(logger, request);
  }
  rclcpp::shutdown();
  return code;
}
