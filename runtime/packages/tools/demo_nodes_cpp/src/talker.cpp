// Says hello once a second.
#include "topics.hpp"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<demo_nodes_cpp::Talker>(rclcpp::NodeOptions()));
  rclcpp::shutdown();
  return 0;
}
