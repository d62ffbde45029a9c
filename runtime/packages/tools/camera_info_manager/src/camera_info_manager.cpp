// See camera_info_manager.hpp.
#include "camera_info_manager/camera_info_manager.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

#include "ament_index_cpp/get_package_share_directory.hpp"
#include "camera_calibration_parsers/parse.hpp"

namespace camera_info_manager {
namespace {

constexpr const char* kDefaultUrl = "file://${ROS_HOME}/camera_info/${NAME}.yaml";
constexpr const char* kFile = "file://";
constexpr const char* kPackage = "package://";

bool begins_with(const std::string& text, const std::string& begin) {
  return text.size() > begin.size() &&
         std::equal(begin.begin(), begin.end(), text.begin(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) ==
                  std::tolower(static_cast<unsigned char>(b));
         });
}

std::string ros_home() {
  if (const char* folder = std::getenv("ROS_HOME")) return folder;
  const char* home = std::getenv("HOME");
  return std::string(home == nullptr ? "" : home) + "/.ros";
}

bool is_name(const std::string& text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '_';
  });
}

}  // namespace

template <typename NodeT>
CameraInfoManager::CameraInfoManager(NodeT& node, const std::string& cname, const std::string& url)
    : logger_(node.get_logger()), name_(cname), url_(url) {
  service_ = node.template create_service<SetCameraInfo>(
      "~/set_camera_info", [this](const std::shared_ptr<SetCameraInfo::Request>& request,
                                  const std::shared_ptr<SetCameraInfo::Response>& response) {
        store(*request, *response);
      });
}

CameraInfoManager::CameraInfoManager(rclcpp::Node* node, const std::string& cname,
                                     const std::string& url)
    : CameraInfoManager(*node, cname, url) {}
CameraInfoManager::CameraInfoManager(rclcpp_lifecycle::LifecycleNode* node,
                                     const std::string& cname, const std::string& url)
    : CameraInfoManager(*node, cname, url) {}

CameraInfo CameraInfoManager::getCameraInfo() {
  load_once();
  const std::lock_guard<std::mutex> lock(mutex_);
  return info_;
}

bool CameraInfoManager::isCalibrated() {
  load_once();
  const std::lock_guard<std::mutex> lock(mutex_);
  return info_.k[0] != 0.0;
}

void CameraInfoManager::load_once() {
  std::string url;
  std::string name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_loaded_) return;
    is_loaded_ = true;
    url = url_;
    name = name_;
  }
  load(url, name);
}

bool CameraInfoManager::loadCameraInfo(const std::string& url) {
  std::string name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    url_ = url;
    is_loaded_ = true;
    name = name_;
  }
  return load(url, name);
}

bool CameraInfoManager::load(const std::string& url, const std::string& cname) {
  if (url.empty()) {
    RCLCPP_INFO(logger_, "using default calibration URL");
    return load(kDefaultUrl, cname);
  }
  RCLCPP_INFO(logger_, "camera calibration URL: %s", resolveURL(url, cname).c_str());
  const std::string file = file_of(url, cname);
  if (file.empty()) return false;
  std::string found_name;
  CameraInfo found;
  if (!camera_calibration_parsers::readCalibration(file, found_name, found)) {
    RCLCPP_WARN(logger_, "Camera calibration file %s not found", file.c_str());
    return false;
  }
  if (cname != found_name) {
    RCLCPP_WARN(logger_, "[%s] does not match %s in file %s", cname.c_str(), found_name.c_str(),
                file.c_str());
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  info_ = found;
  return true;
}

std::string CameraInfoManager::file_of(const std::string& url, const std::string& cname) {
  const std::string resolved = resolveURL(url.empty() ? kDefaultUrl : url, cname);
  if (begins_with(resolved, kFile)) return resolved.substr(std::string(kFile).size());
  if (!validateURL(resolved)) {
    RCLCPP_ERROR(logger_, "Invalid camera calibration URL: %s", resolved.c_str());
    return "";
  }
  const std::string rest = resolved.substr(std::string(kPackage).size());
  const std::string package = rest.substr(0, rest.find('/'));
  try {
    return ament_index_cpp::get_package_share_directory(package) + rest.substr(package.size());
  } catch (const std::exception&) {
    RCLCPP_WARN(logger_, "unknown package: %s (ignored)", package.c_str());
    return "";
  }
}

std::string CameraInfoManager::resolveURL(const std::string& url, const std::string& cname) {
  std::string resolved;
  for (std::size_t i = 0; i < url.size();) {
    const auto stands = [&](const std::string& text) {
      return url.compare(i, text.size(), text) == 0;
    };
    if (stands("${NAME}")) {
      resolved += cname;
      i += 7;
    } else if (stands("${ROS_HOME}")) {
      resolved += ros_home();
      i += 11;
    } else {
      if (stands("${")) {
        RCLCPP_ERROR(logger_, "invalid URL substitution (not resolved): %s", url.c_str());
      }
      resolved += url[i++];
    }
  }
  return resolved;
}

bool CameraInfoManager::setCameraName(const std::string& cname) {
  if (!is_name(cname)) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  name_ = cname;
  is_loaded_ = false;
  return true;
}

bool CameraInfoManager::setCameraInfo(const CameraInfo& camera_info) {
  const std::lock_guard<std::mutex> lock(mutex_);
  info_ = camera_info;
  is_loaded_ = true;
  return true;
}

bool CameraInfoManager::validateURL(const std::string& url) {
  std::string name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    name = name_;
  }
  const std::string resolved = resolveURL(url, name);
  if (resolved.empty() || begins_with(resolved, "file:///")) return true;
  if (!begins_with(resolved, kPackage)) return false;
  // A package, and a file in it.
  const std::string rest = resolved.substr(std::string(kPackage).size());
  const std::size_t slash = rest.find('/');
  return slash != std::string::npos && slash > 0 && slash + 1 < rest.size();
}

void CameraInfoManager::store(const SetCameraInfo::Request& request,
                              SetCameraInfo::Response& response) {
  std::string url;
  std::string name;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    info_ = request.camera_info;
    is_loaded_ = true;
    url = url_;
    name = name_;
  }
  const std::string file = file_of(url, name);
  if (!file.empty()) RCLCPP_INFO(logger_, "writing calibration data to %s", file.c_str());
  response.success = !file.empty() &&
                     camera_calibration_parsers::writeCalibration(file, name, request.camera_info);
  if (!response.success) response.status_message = "Error storing camera calibration.";
}

}  // namespace camera_info_manager
