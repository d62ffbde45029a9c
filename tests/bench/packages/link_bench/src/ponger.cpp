// Sends back what comes on "ping", with the time at which the callback began in its first eight bytes.
#include <chrono>
#include <cstring>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("ponger");
  auto pong = node->create_publisher<Bytes>("pong", 10);
  auto ping = node->create_subscription<Bytes>("ping", 10, [&pong](Bytes::UniquePtr bytes) {
    const auto came = std::chrono::steady_clock::now();
    std::memcpy(bytes->data.data(), &came, sizeof came);
    pong->publish(std::move(bytes));
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
