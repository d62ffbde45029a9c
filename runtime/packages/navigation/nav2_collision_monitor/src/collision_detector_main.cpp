// The program `collision_detector`.
#include <memory>

#include "nav2_collision_monitor/collision_detector_node.hpp"
#include "rclcpp/rclcpp.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<nav2_collision_monitor::CollisionDetector>();
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
