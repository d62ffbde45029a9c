// The turtle simulator. Its window is the page's.
#include "simulator.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("turtlesim");
  const turtlesim::Simulator simulator(node);
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
