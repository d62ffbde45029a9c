// The program `velocity_smoother`.
#include <memory>

#include "nav2_velocity_smoother/velocity_smoother.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<nav2_velocity_smoother::VelocitySmoother>();
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
