// The program `sync_slam_toolbox_node`.
#include <memory>

#include "node/sync.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<slam_toolbox::SynchronousSlamToolbox>();
  rclcpp::spin(node->get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
