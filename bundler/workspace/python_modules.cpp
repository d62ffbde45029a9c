// See python_modules.hpp.
#include "bundler/workspace/python_modules.hpp"

#include <array>

namespace ros2wasm {
namespace {

struct ModulePackage {
  std::string_view module;
  std::string_view package;
};

constexpr auto kPackages = std::to_array<ModulePackage>({
    {"cv2", "python3-opencv"},
    {"cv_bridge", "python3-opencv"},
    {"image_geometry", "python3-opencv"},
    {"numpy", "python3-numpy"},
    {"scipy", "python3-scipy"},
    {"tf2_ros", "tf2_ros_py"},
    {"transforms3d", "python3-transforms3d"},
    {"yaml", "python3-yaml"},
});

constexpr auto kNeeds = std::to_array<ModulePackage>({
    {"tf2_geometry_msgs", "tf2_ros_py"},
    {"tf2_sensor_msgs", "sensor_msgs_py"},
    {"tf2_sensor_msgs", "tf2_ros_py"},
    {"zoneinfo", "tzdata"},
});

}  // namespace

std::string_view package_of_module(std::string_view module) {
  for (const ModulePackage& row : kPackages) {
    if (row.module == module) return row.package;
  }
  return module;
}

std::vector<std::string_view> needs_of_module(std::string_view module) {
  std::vector<std::string_view> result;
  for (const ModulePackage& row : kNeeds) {
    if (row.module == module) result.push_back(row.package);
  }
  return result;
}

}  // namespace ros2wasm
