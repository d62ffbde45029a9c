// Publishes messages of several sizes as fast as they are taken: reliable and keep_all, so nothing is lost.
// Parameters: `sinks`, how many subscriptions to wait for; `largest`, above which sizes are skipped, as in the sinks.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("flooder");
  const auto sinks = static_cast<std::size_t>(node->declare_parameter("sinks", 1));
  // The first case is not counted: a page is busy with itself when it has just started.
  const std::pair<std::uint64_t, std::uint64_t> cases[] = {
    {9, 400000}, {8, 400000}, {1000, 400000}, {64000, 20000}, {6000000, 200}};
  const auto largest = static_cast<std::uint64_t>(node->declare_parameter("largest", 6000000));
  for (const auto & [size, count] : cases) {
    if (size > largest) {break;}
    auto publisher = node->create_publisher<Bytes>("flood_" + std::to_string(size), rclcpp::QoS(rclcpp::KeepAll()));
    while (rclcpp::ok() && publisher->get_subscription_count() < sinks) {
      rclcpp::sleep_for(std::chrono::milliseconds(1));
    }
    Bytes bytes;
    bytes.data.assign(size, 0);
    const std::uint64_t messages = count / sinks;
    for (std::uint64_t i = 0; rclcpp::ok() && i < messages; ++i) {
      const std::uint64_t left = messages - 1 - i;  // 0 in the last message
      std::memcpy(bytes.data.data(), &left, sizeof left);
      publisher->publish(bytes);
    }
    while (rclcpp::ok() && publisher->get_subscription_count() > 0) {
      rclcpp::sleep_for(std::chrono::milliseconds(1));
    }
  }
  // Every sink has printed what it took before its last subscription went.
  std::puts("flooder: done");
  rclcpp::shutdown();
  return 0;
}
