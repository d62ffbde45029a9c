// Prints what is said.
#include "topics.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<demo_nodes_cpp::Listener>(rclcpp::NodeOptions()));
  rclcpp::shutdown();
  return 0;
}
