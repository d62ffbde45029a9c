// See host_packages.hpp.
#include "bundler/workspace/host_packages.hpp"

#include <algorithm>
#include <array>

namespace ros2wasm {
namespace {

struct HostPackage {
  std::string_view name;  ///< one `*` stands for any letters
  std::string_view reason;
};

constexpr std::string_view kBuildTool = "a build tool of this machine";
constexpr std::string_view kTestTool = "tests run in the native build";
constexpr std::string_view kLaunchTool = "launch descriptions are read by ros2wasm itself";
constexpr std::string_view kCommandTool = "a command line tool, of no use in a site";
constexpr std::string_view kWindowTool = "a program with windows; the page shows what it would";
constexpr std::string_view kLeftOut = "what needs it is skipped";
constexpr std::string_view kGazebo = "the simulator of the site takes Gazebo's place";
constexpr std::string_view kOwnMiddleware = "every site has its own middleware";

constexpr auto kHostPackages = std::to_array<HostPackage>({
    {"OpenCV", kLeftOut},
    {"ament_cmake", kBuildTool},
    {"ament_cmake_auto", kBuildTool},
    {"ament_cmake_core", kBuildTool},
    {"ament_cmake_export_*", kBuildTool},
    {"ament_cmake_gen_version_h", kBuildTool},
    {"ament_cmake_gmock", kTestTool},
    {"ament_cmake_google_benchmark", kTestTool},
    {"ament_cmake_gtest", kTestTool},
    {"ament_cmake_include_directories", kBuildTool},
    {"ament_cmake_libraries", kBuildTool},
    {"ament_cmake_pytest", kTestTool},
    {"ament_cmake_python", kBuildTool},
    {"ament_cmake_ros", kBuildTool},
    {"ament_cmake_target_dependencies", kBuildTool},
    {"ament_cmake_test", kTestTool},
    {"ament_cmake_version", kBuildTool},
    {"ament_lint*", kTestTool},
    {"ament_package", kBuildTool},
    {"ament_python", kBuildTool},
    {"cmake", kBuildTool},
    {"cv_bridge", kLeftOut},
    {"gazebo", kGazebo},
    {"gazebo11", kGazebo},
    {"git", kBuildTool},
    {"gz-*", kGazebo},
    {"gz_*_vendor", kGazebo},
    {"ignition-*", kGazebo},
    {"image_geometry", kLeftOut},
    {"joint_state_publisher_gui", kWindowTool},
    {"launch", kLaunchTool},
    {"launch_ros", kLaunchTool},
    {"launch_testing*", kTestTool},
    {"launch_xml", kLaunchTool},
    {"launch_yaml", kLaunchTool},
    {"libgazebo*", kGazebo},
    {"libgz-*", kGazebo},
    {"libignition-*", kGazebo},
    {"libopencv*", kLeftOut},
    {"opencv", kLeftOut},
    {"opencv2", kLeftOut},
    {"libzmq3-dev", kLeftOut},
    {"pkg-config", kBuildTool},
    {"plotjuggler*", kWindowTool},
    {"python3", kBuildTool},
    {"python3-pytest", kTestTool},
    {"python3-setuptools", kBuildTool},
    {"python_cmake_module", kBuildTool},
    {"rmw_cyclonedds_cpp", kOwnMiddleware},
    {"rmw_fastrtps_cpp", kOwnMiddleware},
    {"rmw_implementation", kOwnMiddleware},
    {"rmw_implementation_cmake", kBuildTool},
    {"ros2action", kCommandTool},
    {"ros2bag", kCommandTool},
    {"ros2cli", kCommandTool},
    {"ros2component", kCommandTool},
    {"ros2doctor", kCommandTool},
    {"ros2interface", kCommandTool},
    {"ros2launch", kLaunchTool},
    {"ros2lifecycle", kCommandTool},
    {"ros2node", kCommandTool},
    {"ros2param", kCommandTool},
    {"ros2pkg", kCommandTool},
    {"ros2run", kCommandTool},
    {"ros2service", kCommandTool},
    {"ros2topic", kCommandTool},
    {"ros_environment", kBuildTool},
    {"ros_workspace", kBuildTool},
    {"rosidl_adapter", kBuildTool},
    {"rosidl_cmake", kBuildTool},
    {"rosidl_generator_c", kBuildTool},
    {"rosidl_generator_cpp", kBuildTool},
    {"rosidl_generator_py", kBuildTool},
    {"rqt", kWindowTool},
    {"rviz2", kWindowTool},
    {"sdformat*", kGazebo},
    {"setuptools", kBuildTool},
    {"xacro", kLaunchTool},
});

bool matches(std::string_view pattern, std::string_view name) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return name == pattern;
  return name.size() >= pattern.size() - 1 && name.starts_with(pattern.substr(0, star)) &&
         name.ends_with(pattern.substr(star + 1));
}

}  // namespace

std::string_view host_package_reason(std::string_view name) {
  const auto found = std::find_if(kHostPackages.begin(), kHostPackages.end(),
                                  [&](const HostPackage& row) { return matches(row.name, name); });
  return found == kHostPackages.end() ? std::string_view() : found->reason;
}

}  // namespace ros2wasm
