// Adds two numbers for whoever asks.
#include "services.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<demo_nodes_cpp::ServerNode>(rclcpp::NodeOptions()));
  rclcpp::shutdown();
  return 0;
}
