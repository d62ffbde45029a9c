// usage: joint_state_publisher [URDF_FILE]
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "joint_state_publisher.hpp"

int main(int argc, char** argv) {
  const auto arguments = rclcpp::init_and_remove_ros_arguments(argc, argv);
  std::optional<std::string> file;
  if (arguments.size() > 1) {
    file = arguments[1];
  }
  try {
    rclcpp::spin(std::make_shared<joint_state_publisher::JointStatePublisher>(file));
  } catch (const std::runtime_error& error) {
    RCLCPP_ERROR(rclcpp::get_logger("joint_state_publisher"), "%s", error.what());
    return 1;
  }
  rclcpp::shutdown();
  return 0;
}
