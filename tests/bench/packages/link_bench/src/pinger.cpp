// Measures round trips of several sizes, one message under way at a time. One JSON line per size:
// bytes of the payload, round trips, median and 99th percentile in microseconds.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;
using Clock = std::chrono::steady_clock;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("pinger");
  auto ping = node->create_publisher<Bytes>("ping", 10);
  std::size_t heard = 0;
  auto pong = node->create_subscription<Bytes>("pong", 10, [&heard](const Bytes &) {++heard;});
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  while (rclcpp::ok() && (ping->get_subscription_count() == 0 || pong->get_publisher_count() == 0)) {
    executor.spin_once(std::chrono::milliseconds(10));
  }
  constexpr std::size_t warm_up = 100;
  const std::pair<std::size_t, std::size_t> cases[] = {{8, 4000}, {1000, 4000}, {64000, 1000}, {1000000, 200}};
  for (const auto & [size, count] : cases) {
    Bytes bytes;
    bytes.data.assign(size, 42);
    std::vector<double> microseconds;
    for (std::size_t i = 0; rclcpp::ok() && i < warm_up + count; ++i) {
      const std::size_t before = heard;
      const auto begin = Clock::now();
      ping->publish(bytes);
      while (rclcpp::ok() && heard == before) {executor.spin_once();}
      if (i >= warm_up) {
        microseconds.push_back(std::chrono::duration<double, std::micro>(Clock::now() - begin).count());
      }
    }
    if (microseconds.empty()) {break;}
    std::sort(microseconds.begin(), microseconds.end());
    std::printf(
      "{\"bytes\": %zu, \"round_trips\": %zu, \"p50_us\": %.2f, \"p99_us\": %.2f}\n", size, microseconds.size(),
      microseconds[microseconds.size() / 2], microseconds[microseconds.size() * 99 / 100]);
    std::fflush(stdout);
  }
  std::puts("pinger: done");
  rclcpp::shutdown();
  return 0;
}
