// Calibrations of cameras in files, as YAML. Those of other forms are refused.
#pragma once

#include <string>

#include "sensor_msgs/msg/camera_info.hpp"

namespace camera_calibration_parsers {

using CameraInfo = sensor_msgs::msg::CameraInfo;

/// By the file's ending, .yaml or .yml; folders are made. False, with a line in the log, when it
/// cannot be written or read.
bool writeCalibration(const std::string& file_name, const std::string& camera_name,
                      const CameraInfo& cam_info);
bool readCalibration(const std::string& file_name, std::string& camera_name, CameraInfo& cam_info);
/// Reads a text; the format is "yml" or "yaml".
bool parseCalibration(const std::string& buffer, const std::string& format,
                      std::string& camera_name, CameraInfo& cam_info);

bool writeCalibrationYml(const std::string& file_name, const std::string& camera_name,
                         const CameraInfo& cam_info);
bool readCalibrationYml(const std::string& file_name, std::string& camera_name,
                        CameraInfo& cam_info);
bool parseCalibrationYml(const std::string& buffer, std::string& camera_name, CameraInfo& cam_info);

}  // namespace camera_calibration_parsers
