// See parse.hpp.
#include "camera_calibration_parsers/parse.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "rcutils/logging_macros.h"
#include "sensor_msgs/distortion_models.hpp"

namespace camera_calibration_parsers {
namespace {

constexpr const char* kLogger = "camera_calibration_parsers";

bool is_yaml(const std::string& ending) {
  return ending == "yml" || ending == "yaml";
}

std::string ending_of(const std::string& file_name) {
  const std::string ending = std::filesystem::path(file_name).extension().string();
  return ending.empty() ? ending : ending.substr(1);
}

template <typename NumbersT>
void write_matrix(YAML::Emitter& out, const char* key, std::size_t rows, const NumbersT& numbers) {
  out << YAML::Key << key << YAML::Value << YAML::BeginMap;
  out << YAML::Key << "rows" << YAML::Value << rows;
  out << YAML::Key << "cols" << YAML::Value << (rows == 0 ? 0 : numbers.size() / rows);
  out << YAML::Key << "data" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const double number : numbers) out << number;
  out << YAML::EndSeq << YAML::EndMap;
}

/// Throws YAML::Exception when there are not so many numbers as the matrix has places.
template <typename NumbersT>
void read_matrix(const YAML::Node& document, const char* key, NumbersT& numbers) {
  const auto read = document[key]["data"].as<std::vector<double>>();
  if (read.size() != numbers.size()) {
    throw YAML::Exception(document[key].Mark(),
                          std::string(key) + " has " + std::to_string(read.size()) + " numbers");
  }
  std::copy(read.begin(), read.end(), numbers.begin());
}

template <typename T>
void read_if_there(const YAML::Node& of, const char* key, T& value) {
  if (of[key]) value = of[key].as<T>();
}

}  // namespace

bool writeCalibrationYml(const std::string& file_name, const std::string& camera_name,
                         const CameraInfo& cam_info) {
  std::error_code error;
  const auto folder = std::filesystem::path(file_name).parent_path();
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  std::ofstream file(file_name);
  if (!file) {
    RCUTILS_LOG_ERROR_NAMED(kLogger, "Unable to open camera calibration file [%s] for writing",
                            file_name.c_str());
    return false;
  }
  YAML::Emitter out;
  const auto value = [&](const char* key, const auto& of) {
    out << YAML::Key << key << YAML::Value << of;
  };
  out << YAML::BeginMap;
  value("image_width", cam_info.width);
  value("image_height", cam_info.height);
  value("camera_name", camera_name);
  write_matrix(out, "camera_matrix", 3, cam_info.k);
  value("distortion_model", cam_info.distortion_model);
  write_matrix(out, "distortion_coefficients", 1, cam_info.d);
  write_matrix(out, "rectification_matrix", 3, cam_info.r);
  write_matrix(out, "projection_matrix", 3, cam_info.p);
  value("binning_x", cam_info.binning_x);
  value("binning_y", cam_info.binning_y);
  out << YAML::Key << "roi" << YAML::Value << YAML::BeginMap;
  value("x_offset", cam_info.roi.x_offset);
  value("y_offset", cam_info.roi.y_offset);
  value("height", cam_info.roi.height);
  value("width", cam_info.roi.width);
  value("do_rectify", cam_info.roi.do_rectify);
  out << YAML::EndMap << YAML::EndMap;
  file << out.c_str();
  return static_cast<bool>(file.flush());
}

bool parseCalibrationYml(const std::string& buffer, std::string& camera_name,
                         CameraInfo& cam_info) {
  try {
    const YAML::Node document = YAML::Load(buffer);
    camera_name = "unknown";
    read_if_there(document, "camera_name", camera_name);
    cam_info.width = document["image_width"].as<uint32_t>();
    cam_info.height = document["image_height"].as<uint32_t>();
    read_matrix(document, "camera_matrix", cam_info.k);
    read_matrix(document, "rectification_matrix", cam_info.r);
    read_matrix(document, "projection_matrix", cam_info.p);
    cam_info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
    if (!document["distortion_model"]) {
      RCUTILS_LOG_WARN_NAMED(
          kLogger, "Camera calibration file did not specify distortion model, assuming plumb bob");
    }
    read_if_there(document, "distortion_model", cam_info.distortion_model);
    cam_info.d = document["distortion_coefficients"]["data"].as<std::vector<double>>();
    read_if_there(document, "binning_x", cam_info.binning_x);
    read_if_there(document, "binning_y", cam_info.binning_y);
    if (const YAML::Node roi = document["roi"]) {
      read_if_there(roi, "x_offset", cam_info.roi.x_offset);
      read_if_there(roi, "y_offset", cam_info.roi.y_offset);
      read_if_there(roi, "height", cam_info.roi.height);
      read_if_there(roi, "width", cam_info.roi.width);
      read_if_there(roi, "do_rectify", cam_info.roi.do_rectify);
    }
    return true;
  } catch (const YAML::Exception& error) {
    RCUTILS_LOG_WARN_NAMED(kLogger, "Exception parsing YAML camera calibration:\n%s", error.what());
    return false;
  }
}

bool readCalibrationYml(const std::string& file_name, std::string& camera_name,
                        CameraInfo& cam_info) {
  const std::ifstream file(file_name);
  if (!file) {
    RCUTILS_LOG_ERROR_NAMED(kLogger, "Unable to open camera calibration file [%s]",
                            file_name.c_str());
    return false;
  }
  std::ostringstream text;
  text << file.rdbuf();
  if (parseCalibrationYml(text.str(), camera_name, cam_info)) return true;
  RCUTILS_LOG_ERROR_NAMED(kLogger, "Failed to parse camera calibration from file [%s]",
                          file_name.c_str());
  return false;
}

bool writeCalibration(const std::string& file_name, const std::string& camera_name,
                      const CameraInfo& cam_info) {
  return is_yaml(ending_of(file_name)) && writeCalibrationYml(file_name, camera_name, cam_info);
}

bool readCalibration(const std::string& file_name, std::string& camera_name, CameraInfo& cam_info) {
  return is_yaml(ending_of(file_name)) && readCalibrationYml(file_name, camera_name, cam_info);
}

bool parseCalibration(const std::string& buffer, const std::string& format,
                      std::string& camera_name, CameraInfo& cam_info) {
  return is_yaml(format) && parseCalibrationYml(buffer, camera_name, cam_info);
}

}  // namespace camera_calibration_parsers
