// Publishes `bytes` bytes `hz` times a second on `topic`: the time and a number in front. With `log` it says each number.
// Every `report_s` seconds one JSON line: how many it was.
#include <chrono>
#include <cstring>

#include "latencies.hpp"
#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("pulse");
  const auto topic = node->declare_parameter("topic", "pulse");
  const auto bytes = node->declare_parameter("bytes", 100);
  const auto hz = node->declare_parameter("hz", 10);
  const bool log = node->declare_parameter("log", false);
  const auto report_s = node->declare_parameter("report_s", 60);
  auto publisher = node->create_publisher<Bytes>(topic, 50);
  Bytes message;
  message.data.resize(static_cast<std::size_t>(bytes));
  std::uint64_t number = 0;
  auto timer = node->create_wall_timer(std::chrono::nanoseconds(1'000'000'000 / hz), [&] {
    ++number;
    const std::int64_t time = now_ns();
    std::memcpy(message.data.data(), &time, sizeof time);
    std::memcpy(message.data.data() + sizeof time, &number, sizeof number);
    publisher->publish(message);
    if (log) {
      RCLCPP_INFO(node->get_logger(), "number %llu", static_cast<unsigned long long>(number));
    }
  });
  std::uint64_t told = 0;
  auto reports = node->create_wall_timer(std::chrono::seconds(report_s), [&] {
    report_published(topic.c_str(), number - told);
    told = number;
  });
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}
