// See map_yaml.hpp.
#include "map_yaml.hpp"

#include <iomanip>
#include <sstream>
#include <vector>

#include "yaml-cpp/yaml.h"

namespace nav2_map_server {
namespace {

/// Cells of a trinary map are saved as pixels of 0, 205 and 254. These tell them apart.
constexpr double kTrinaryOccupied = 0.65;
constexpr double kTrinaryFree = 0.196;
constexpr int kDigits = 7;

template <typename T>
T value_of(const YAML::Node& document, const char* tag) {
  try {
    return document[tag].as<T>();
  } catch (const YAML::Exception& error) {
    throw YAML::Exception(
        error.mark, std::string("Failed to parse YAML tag '") + tag + "' for reason: " + error.msg);
  }
}

bool negate_of(const YAML::Node& document) {
  try {
    return value_of<int>(document, "negate") != 0;
  } catch (const YAML::Exception&) {
    return value_of<bool>(document, "negate");
  }
}

std::string fixed(double value) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << value;
  return text.str();
}

}  // namespace

LoadParameters read_map_yaml(const std::string& text, const std::string& folder) {
  if (text.size() > kMostYamlBytes) {
    throw YAML::Exception(YAML::Mark::null_mark(), "the file has more than 1 MiB");
  }
  const YAML::Node document = YAML::Load(text);
  LoadParameters parameters;
  parameters.image_file_name = value_of<std::string>(document, "image");
  if (parameters.image_file_name.empty()) {
    throw YAML::Exception(document["image"].Mark(), "The image tag was empty.");
  }
  if (parameters.image_file_name.front() != '/') {
    parameters.image_file_name = folder + "/" + parameters.image_file_name;
  }
  parameters.resolution = value_of<double>(document, "resolution");
  parameters.origin = value_of<std::vector<double>>(document, "origin");
  if (parameters.origin.size() != 3) {
    throw YAML::Exception(document["origin"].Mark(),
                          "value of the 'origin' tag should have 3 elements, not " +
                              std::to_string(parameters.origin.size()));
  }
  parameters.free_thresh = value_of<double>(document, "free_thresh");
  parameters.occupied_thresh = value_of<double>(document, "occupied_thresh");
  if (const YAML::Node mode = document["mode"]; mode.IsDefined()) {
    parameters.mode = map_mode_from_string(mode.as<std::string>());
  }
  parameters.negate = negate_of(document);
  return parameters;
}

std::string map_yaml(const std::string& image_name, const MapPlace& place,
                     const SaveParameters& parameters) {
  YAML::Emitter out;
  out << YAML::Precision(kDigits) << YAML::BeginMap;
  out << YAML::Key << "image" << YAML::Value << image_name;
  out << YAML::Key << "mode" << YAML::Value << map_mode_to_string(parameters.mode);
  out << YAML::Key << "resolution" << YAML::Value << fixed(place.resolution);
  out << YAML::Key << "origin" << YAML::Value << YAML::Flow << YAML::BeginSeq << fixed(place.x)
      << fixed(place.y) << place.yaw << YAML::EndSeq;
  out << YAML::Key << "negate" << YAML::Value << 0;
  out << YAML::Key << "occupied_thresh" << YAML::Value;
  if (parameters.mode == MapMode::Trinary) {
    out << kTrinaryOccupied << YAML::Key << "free_thresh" << YAML::Value << kTrinaryFree;
  } else {
    out << fixed(parameters.occupied_thresh) << YAML::Key << "free_thresh" << YAML::Value
        << fixed(parameters.free_thresh);
  }
  out << YAML::EndMap;
  return out.c_str();
}

}  // namespace nav2_map_server
