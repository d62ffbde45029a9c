// Runs an extended Kalman filter as a node.
#include <memory>

#include "filter/ekf.hpp"
#include "node/filter_node.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  auto node = std::make_shared<robot_localization::FilterNode>(
      "ekf_filter_node", std::make_unique<robot_localization::Ekf>());
  node->start();
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
