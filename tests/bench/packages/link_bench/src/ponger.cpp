// Sends back what comes on "ping", as it is.
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("ponger");
  auto pong = node->create_publisher<Bytes>("pong", 10);
  auto ping = node->create_subscription<Bytes>(
    "ping", 10, [&pong](const Bytes & bytes) {pong->publish(bytes);});
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
