// A camera's calibration: from a file, and from whoever sets it.

// Compatibility, works: camera_info_manager (`CameraInfoManager`, `~/set_camera_info`, URLs of files and packages) and
// camera_calibration_parsers (YAML)

// Compatibility, differs: calibrations of cameras as INI files -> refused, as other forms than YAML are; what `set_camera_info` writes lives
// in the node's memory, as all files that a node writes

#include <cstdlib>
#include <fstream>
#include <string>

#include "camera_calibration_parsers/parse.hpp"
#include "camera_info_manager/camera_info_manager.hpp"
#include "checks.hpp"

namespace {

using sensor_msgs::msg::CameraInfo;

constexpr const char* kCalibration = R"(image_width: 640
image_height: 480
camera_name: front
camera_matrix: {rows: 3, cols: 3, data: [500, 0, 320, 0, 510, 240, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients:
  rows: 1
  cols: 5
  data: [0.1, -0.2, 0.001, 0.002, 0]
rectification_matrix: {rows: 3, cols: 3, data: [1, 0, 0, 0, 1, 0, 0, 0, 1]}
projection_matrix: {rows: 3, cols: 4, data: [505, 0, 321, 0, 0, 515, 241, 0, 0, 0, 1, 0]}
)";

void check_files(Checks& checks) {
  std::string name;
  CameraInfo info;
  CHECK(camera_calibration_parsers::parseCalibration(kCalibration, "yml", name, info));
  CHECK(name == "front" && info.width == 640 && info.k[4] == 510 && info.p[6] == 241);
  CHECK(info.d.size() == 5 && info.d[1] == -0.2 && info.distortion_model == "plumb_bob");
  CHECK(!camera_calibration_parsers::parseCalibration("image_width: 3", "yaml", name, info));
  CHECK(!camera_calibration_parsers::parseCalibration(kCalibration, "ini", name, info));
  info.roi.width = 12;
  info.binning_x = 2;
  CHECK(camera_calibration_parsers::writeCalibration("/tmp/deep/er/cam.yaml", "cam", info));
  CameraInfo read;
  CHECK(camera_calibration_parsers::readCalibration("/tmp/deep/er/cam.yaml", name, read));
  CHECK(name == "cam" && read == info);
  CHECK(!camera_calibration_parsers::readCalibration("/tmp/none.yaml", name, read));
}

void check_manager(Checks& checks) {
  setenv("ROS_HOME", "/tmp/home", 1);
  std::ofstream("/tmp/front.yaml") << kCalibration;
  const auto node = rclcpp::Node::make_shared("driver");
  camera_info_manager::CameraInfoManager manager(node.get(), "front", "file:///tmp/${NAME}.yaml");
  CHECK(manager.isCalibrated() && manager.getCameraInfo().k[0] == 500);
  CHECK(manager.resolveURL("${ROS_HOME}/${NAME}/${OTHER}", "left") == "/tmp/home/left/${OTHER}");
  CHECK(manager.validateURL("package://some/file.yaml") && manager.validateURL(""));
  CHECK(!manager.validateURL("package://some") && !manager.validateURL("http://a/b"));
  CHECK(!manager.setCameraName("a b") && manager.setCameraName("left"));
  CHECK(!manager.loadCameraInfo("package://nobody/file.yaml"));
  CHECK(!manager.loadCameraInfo(""));  // the file that the service below writes

  const auto caller = rclcpp::Node::make_shared("caller");
  const auto client = caller->create_client<sensor_msgs::srv::SetCameraInfo>("driver/set_camera_info");
  CHECK(client->wait_for_service(std::chrono::seconds(10)));
  auto request = std::make_shared<sensor_msgs::srv::SetCameraInfo::Request>();
  std::string name;
  camera_calibration_parsers::parseCalibration(kCalibration, "yml", name, request->camera_info);
  request->camera_info.width = 320;
  auto answer = client->async_send_request(request);
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.add_node(caller);
  CHECK(executor.spin_until_future_complete(answer, std::chrono::seconds(10)) ==
        rclcpp::FutureReturnCode::SUCCESS);
  CHECK(answer.get()->success && manager.getCameraInfo().width == 320);
  CameraInfo read;
  CHECK(camera_calibration_parsers::readCalibration("/tmp/home/camera_info/left.yaml", name, read));
  CHECK(name == "left" && read.width == 320);
}

}  // namespace

int main(int argc, char* argv[]) {
  rclcpp::init(argc, argv);
  Checks checks("calibration");
  check_files(checks);
  check_manager(checks);
  return checks.finish();
}
