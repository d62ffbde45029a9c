// The program `navsat_transform_node`.
#include <memory>

#include "node/navsat_transform.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<robot_localization::NavSatTransform>());
  rclcpp::shutdown();
  return 0;
}
