// Takes what a flooder publishes. One JSON line per size: bytes of a payload, messages taken, messages lost, and
// messages per second between the first and the last. Parameter `largest`: sizes above it are skipped.
#include <chrono>
#include <cstdio>
#include <cstring>
#include <string>

#include "rclcpp/rclcpp.hpp"
#include "std_msgs/msg/u_int8_multi_array.hpp"

using Bytes = std_msgs::msg::UInt8MultiArray;
using Clock = std::chrono::steady_clock;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("sink");
  const auto largest = static_cast<std::uint64_t>(node->declare_parameter("largest", 6000000));
  for (const std::uint64_t size : {9ULL, 8ULL, 1000ULL, 64000ULL, 6000000ULL}) {
    if (size > largest) {break;}
    std::uint64_t taken = 0;
    std::uint64_t expected = 0;
    bool over = false;
    Clock::time_point begin;
    Clock::time_point end;
    auto subscription = node->create_subscription<Bytes>(
      "flood_" + std::to_string(size), rclcpp::QoS(rclcpp::KeepAll()), [&](const Bytes & bytes) {
        std::uint64_t left = 0;
        std::memcpy(&left, bytes.data.data(), sizeof left);
        // The clock is asked twice in all: to ask costs as much as to take a message.
        if (taken++ == 0) {
          begin = Clock::now();
          expected = left + 1;
        }
        over = left == 0;
        if (over) {end = Clock::now();}
      });
    rclcpp::executors::SingleThreadedExecutor executor;
    executor.add_node(node);
    while (rclcpp::ok() && !over) {executor.spin_once();}
    const double seconds = std::chrono::duration<double>(end - begin).count();
    std::printf(
      "{\"bytes\": %llu, \"taken\": %llu, \"lost\": %llu, \"per_second\": %.0f}\n",
      static_cast<unsigned long long>(size), static_cast<unsigned long long>(taken),
      static_cast<unsigned long long>(expected - taken), static_cast<double>(taken - 1) / seconds);
    std::fflush(stdout);
  }
  rclcpp::shutdown();
  return 0;
}
