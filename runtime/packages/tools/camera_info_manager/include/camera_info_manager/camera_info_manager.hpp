// The calibration of a camera, for its driver. It is read from a file; a call of
// `~/set_camera_info` replaces it and writes it to that file.
#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "sensor_msgs/msg/camera_info.hpp"
#include "sensor_msgs/srv/set_camera_info.hpp"

namespace camera_info_manager {

using CameraInfo = sensor_msgs::msg::CameraInfo;
using SetCameraInfo = sensor_msgs::srv::SetCameraInfo;

class CameraInfoManager {
 public:
  explicit CameraInfoManager(rclcpp::Node* node, const std::string& cname = "camera",
                             const std::string& url = "");
  explicit CameraInfoManager(rclcpp_lifecycle::LifecycleNode* node,
                             const std::string& cname = "camera", const std::string& url = "");

  /// Nothing is read before this is asked, or isCalibrated(), or loadCameraInfo(). Empty when there
  /// is none; time and frame are the driver's to set.
  [[nodiscard]] CameraInfo getCameraInfo();
  [[nodiscard]] bool isCalibrated();
  /// False when the URL has none. `file:///...` and `package://...`, with ${NAME} and ${ROS_HOME}.
  bool loadCameraInfo(const std::string& url);
  [[nodiscard]] std::string resolveURL(const std::string& url, const std::string& cname);
  /// Letters, digits and `_`; false for other names.
  bool setCameraName(const std::string& cname);
  bool setCameraInfo(const CameraInfo& camera_info);
  [[nodiscard]] bool validateURL(const std::string& url);

 private:
  template <typename NodeT>
  CameraInfoManager(NodeT& node, const std::string& cname, const std::string& url);

  /// The file that a URL names; empty, with a line in the log, when it names none.
  [[nodiscard]] std::string file_of(const std::string& url, const std::string& cname);
  bool load(const std::string& url, const std::string& cname);
  void load_once();
  void store(const SetCameraInfo::Request& request, SetCameraInfo::Response& response);

  rclcpp::Logger logger_;
  std::mutex mutex_;  ///< of all below
  std::string name_;
  std::string url_;
  CameraInfo info_;
  bool is_loaded_ = false;
  rclcpp::Service<SetCameraInfo>::SharedPtr service_;
};

}  // namespace camera_info_manager
