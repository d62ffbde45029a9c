// Asks for 2 + 3, and spins until it is told.
#include "services.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<demo_nodes_cpp::ClientNode>(rclcpp::NodeOptions()));
  rclcpp::shutdown();
  return 0;
}
